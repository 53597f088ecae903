// fogcomp diagnose: where and why a model fails.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/diagnosis_json.hpp"
#include "cli/diagnosis_text.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "recording/data_hash.hpp"
#include "report/diagnose_report.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

struct DiagnoseCommand : Command {
  Texts expressions{this,
                    {"effect-expr", "EXPR",
                     "a candidate of your own beside the catalogue's, e.g. 'burst = T*T*dTdt'"}};
  Text at_rest{this, {"static", "RUN", "recording at rest: the noise is taken from there"}};
  Integer<int> max_effects{
      this,
      {"max-effects", "N", "add what is found, refit, look again, up to N times", "0"},
      0,
      12};
  Number average{this, {"average", "S", "rows, seconds (default: as fitted)"}, {1e-3, 1e6}};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the draws that calibrate the test", "1"}, 0, INT64_MAX};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  DiagnoseCommand()
      : Command("diagnose", {"MODEL RUN...", 2, kAnyNumber},
                "where and why the model fails: which effect is missing",
                "fogcomp diagnose gyro.model run.csv --max-effects 4") {}
  int run() const override;

 private:
  std::vector<EffectTerm> offered(const Model& model) const;
};

// Expressions that are to compete with the catalogue.
std::vector<EffectTerm> DiagnoseCommand::offered(const Model& model) const {
  std::vector<EffectTerm> terms = model.terms;
  for (const std::string& definition : expressions.value()) add_expression(terms, definition);
  return {terms.begin() + static_cast<std::ptrdiff_t>(model.terms.size()), terms.end()};
}

int DiagnoseCommand::run() const {
  const std::vector<std::string>& files = arguments;
  ReportFile page(report);
  Model model = load_model(files[0]);
  model.average_s = average.find().value_or(model.average_s);
  const int most_effects = max_effects.value();
  DiagnosisSettings settings;
  settings.seed = seed.value();
  ReadOptions options = recording.value();
  options.model_scale_factor = model.scale_factor;
  DiagnosisData data(model, offered(model));
  std::string runs;
  BoardError as_given;
  std::vector<std::string> notes;
  for (std::size_t i = 1; i < files.size(); ++i) {
    const RunInBlocks run = run_in_blocks(read_recording(files[i], options), model.average_s);
    const std::string same = data.add(run);
    if (!same.empty()) {
      print_notes({same_rows_words(files[i], same)});
      continue;
    }
    notes.insert(notes.end(), run.notes.begin(), run.notes.end());
    as_given.add(board_error(model, run, compare_with(model, run)));
    runs += (runs.empty() ? "" : " ") + files[i];
  }
  if (at_rest.given()) {
    settings.noise = noise_of_static(model, read_recording(at_rest.value(), options), data);
  }
  Ladder ladder;
  {
    Progress progress("diagnosing");
    settings.progress = [&](double done) { progress.update(done); };
    ladder = walk_ladder(model, data, most_effects, settings);
  }
  print_notes(notes);
  ladder.first.as_given = as_given;
  if (page.wanted()) {
    page.write(report::diagnose_report(ladder, most_effects > 0, data, files));
  }
  if (json.given()) {
    const Json object = most_effects > 0 ? ladder_json(ladder) : diagnosis_json(ladder.first);
    std::puts(object.text().c_str());
    return 0;
  }
  std::fputs(diagnosis_text(ladder.first, files[0], runs).c_str(), stdout);
  if (most_effects > 0) std::fputs(ladder_text(ladder).c_str(), stdout);
  return 0;
}

}  // namespace

CommandPointer diagnose_command() {
  return std::make_unique<DiagnoseCommand>();
}

}  // namespace fogcomp::cli
