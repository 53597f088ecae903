#include "report/compare_report.hpp"

#include <algorithm>
#include <cmath>

#include "report/figures.hpp"
#include "report/run_section.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

// The run that the first model serves worst.
const ModelOnRun& worst_of(const ModelOnRuns& model) {
  const auto drift = [](const ModelOnRun& run) {
    return floor_removed(run.comparison.whole.rms_dph, run.comparison.noise_floor_dph.value_or(0));
  };
  return *std::max_element(
      model.runs.begin(), model.runs.end(),
      [&](const ModelOnRun& a, const ModelOnRun& b) { return drift(a) < drift(b); });
}

// The model whose worst run is best.
const ModelOnRuns& best_of(const std::vector<ModelOnRuns>& models) {
  const auto worst_rms = [](const ModelOnRuns& model) {
    return worst_of(model).comparison.whole.rms_dph;
  };
  return *std::min_element(
      models.begin(), models.end(),
      [&](const ModelOnRuns& a, const ModelOnRuns& b) { return worst_rms(a) < worst_rms(b); });
}

std::string found(const ModelOnRuns& model, bool of_several) {
  const Comparison& worst = worst_of(model).comparison;
  const std::string where = model.runs.size() == 1 ? "" : "at worst, on " + worst.file + ", ";
  return (of_several ? "Least is left by " : "") + model.file + ": " + where + error_words(worst) +
         " deg/h.";
}

}  // namespace

Report compare_report(const std::vector<ModelOnRuns>& models) {
  const ModelOnRuns& first = models[0];
  std::string subject = "fogcomp compare " + first.file + run_files(first);
  for (std::size_t i = 1; i < models.size(); ++i) subject += " --model " + models[i].file;
  const ModelOnRuns& best = best_of(models);
  Report report(subject, found(best, models.size() > 1));
  if (std::any_of(best.runs.begin(), best.runs.end(), leaves_drift)) {
    report.next("ask which effect is missing.", "fogcomp diagnose " + best.file + run_files(best));
  } else {
    report.next("nothing above the noise floor is left on these runs: make the board's header.",
                "fogcomp export " + best.file + " -o fog_model.h");
  }
  for (std::size_t run = 0; run < first.runs.size(); ++run) add_run(report, models, run);
  return report;
}

}  // namespace fogcomp::report
