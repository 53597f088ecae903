#include "findings/findings.hpp"

#include "findings/compare_words.hpp"
#include "findings/next_step_words.hpp"
#include "findings/run_section.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

Text found(const std::vector<const compare::ModelOnRuns*>& models) {
  const compare::ModelOnRuns& best = *models[0];
  std::vector<std::string> files;
  for (const compare::ModelOnRuns* model : models) files.push_back(model->file);
  const compare::Comparison& worst = best.worst().comparison;
  Text text = verbatim(short_names(files)[0]) + (models.size() > 1 ? " is best: " : ": ");
  if (best.runs.size() > 1) {
    text += "at worst, on " + verbatim(short_names({worst.file})[0]) + ", ";
  }
  return text + words(error_words(worst));
}

Next next_after_comparison(const compare::ModelOnRuns& best) {
  if (leaves_drift(best)) return next_diagnosis(best);
  const char* const why =
      floor_is_unknown(best)
          ? "how much of the rest is noise, so few rows do not show; if it is small enough, make "
            "the board's header"
          : "nothing above the noise floor is left on these runs: make the board's header";
  return next_export(why, best.model, best.file);
}

}  // namespace

Document compare_findings(const std::vector<compare::ModelOnRuns>& models) {
  const compare::ModelOnRuns& first = models[0];
  std::string subject = "fogcomp compare " + first.file + " " + join(run_files(first), " ");
  for (std::size_t i = 1; i < models.size(); ++i) subject += " --model " + models[i].file;
  const std::vector<const compare::ModelOnRuns*> ranked = compare::best_first(models);
  const compare::ModelOnRuns& best = *ranked[0];
  Document document{subject, found(ranked)};
  document.next = next_after_comparison(best);
  document.parts = sentences(turn_on_sentences(best.turn_on));
  for (std::size_t run = 0; run < first.runs.size(); ++run) {
    document.parts += run_section(ranked, run, Shown::everywhere);
  }
  return document;
}

}  // namespace fogcomp::findings
