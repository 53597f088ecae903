#include "findings/findings.hpp"

#include "findings/diagnosis_words.hpp"
#include "findings/next_step_words.hpp"
#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

// The same diagnosis of the selection's model, with the expressions that are not yet in it.
std::vector<std::string> go_on_command(const diagnosis::Ladder& ladder,
                                       const diagnosis::DiagnosisData& data,
                                       const DiagnosedFiles& files) {
  std::vector<std::string> command = diagnose_command(files.output, files.runs, files.holdouts);
  command.insert(command.end(), files.options.begin(), files.options.end());
  for (const model::EffectTerm& offered : data.offered()) {
    if (ladder.model.find(offered.name) != nullptr) continue;
    const model::Expression& expression = offered.expression->expression;
    command.insert(command.end(), {"--effect-expr", expression.name + " = " + expression.text});
  }
  return command;
}

}  // namespace

Parts ladder_section(const diagnosis::Ladder& ladder, const DiagnosedFiles& files,
                     const std::vector<std::string>& names) {
  Table table;
  table.caption = "everything refitted at each step";
  table.columns = {"step", {"rms left", "residual"}, "out of sample"};
  table.quantity = "rms left, deg/h";
  table.floor = ladder.first.noise_floor_dph;
  const double first_dph = ladder.steps.empty() ? ladder.first.residual_rms_dph
                                                : ladder.steps.front().addition.fitted_before_dph;
  Table::Row first{"the model, refitted", {number(first_dph), first_dph}, ""};
  first.colour = "measured";
  table.rows.push_back(std::move(first));
  for (const diagnosis::Ladder::Step& step : ladder.steps) {
    const diagnosis::TriedAddition& tried = step.addition;
    // A cut foretells nothing of other rows.
    const Text judged = tried.request.cuts.empty()
                            ? number(tried.rms_before_dph) + " -> " + number(tried.rms_after_dph)
                            : Text("");
    table.rows.push_back({words(step_words(step), names),
                          {number(tried.fitted_after_dph), tried.fitted_after_dph},
                          judged});
  }
  Parts parts = Heading{"Error ladder"} + table + Sentence{words(end_words(ladder), names)};
  if (ladder.steps.empty()) return parts;
  if (const auto& uncertain = ladder.model.uncertain) parts += Sentence{words(uncertain->words())};
  return parts + Sentence{"the same, step by step:"} +
         Listing{"  " + join(ladder_commands(ladder, files), "\n  ") + "\n"};
}

Next next_after_ladder(const diagnosis::Ladder& ladder, const diagnosis::DiagnosisData& data,
                       const DiagnosedFiles& files) {
  if (ladder.last.verdict == diagnosis::Verdict::none) {
    return next_export("make the board's header", ladder.model, files.output);
  }
  if (ladder.is_cut_off) {
    return {"the loop may add no more; ask what is still missing",
            go_on_command(ladder, data, files)};
  }
  for (const auto* experiment : {&ladder.last.experiment, &ladder.last_next.experiment}) {
    if (*experiment && !(*experiment)->profile.empty()) return words((*experiment)->sentence);
  }
  std::vector<std::string> compare{"fogcomp", "compare", files.output};
  compare.insert(compare.end(), files.runs.begin(), files.runs.end());
  return {"what is left has no name; see where it is", compare};
}

}  // namespace fogcomp::findings
