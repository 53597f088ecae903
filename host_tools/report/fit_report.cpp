#include "report/fit_report.hpp"

#include <algorithm>

#include "report/figures.hpp"
#include "report/run_section.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

std::string found(const ModelOnRuns& model, const FitResult& result) {
  std::string text =
      format("The model leaves %s deg/h rms of a raw std of %s",
             rounded(model.model.residual_rms_dph).c_str(), rounded(result.raw_std_dph).c_str());
  if (const auto floor = model.model.history.back().noise_floor_dph) {
    text += format("; noise alone would leave %s", rounded(*floor).c_str());
  }
  return text + ".";
}

// A list of effects that can be broken into lines.
std::string spaced(const std::string& list) {
  std::string text;
  for (const char character : list) text += character == ',' ? ", " : std::string(1, character);
  return text;
}

void add_ladder(Report& report, const std::vector<HistoryEntry>& history) {
  Bars bars;
  bars.floor = history.back().noise_floor_dph.value_or(0);
  bars.caption = "deg/h rms on the data of the fit.";
  if (bars.floor > 0) bars.caption += " Dashed: the noise floor.";
  const double before_dph = history.front().rms_before_dph;
  bars.rows.push_back({"before", {{before_dph, "measured", dph(before_dph)}}, ""});
  for (const HistoryEntry& step : history) {
    bars.rows.push_back(
        {spaced(step.action), {{step.rms_after_dph, "residual", dph(step.rms_after_dph)}}, ""});
  }
  report.section("Error ladder");
  report.bars(bars);
}

}  // namespace

Report fit_report(const ModelOnRuns& model, const FitResult& result,
                  const std::string& identification) {
  Report report("fogcomp fit" + run_files(model) + " -o " + model.file, found(model, result));
  if (std::any_of(model.runs.begin(), model.runs.end(), leaves_drift)) {
    report.next("ask which effect is missing.",
                "fogcomp diagnose " + model.file + run_files(model));
  } else {
    report.next(
        "nothing above the noise floor is left; judge the model on a run that it was not "
        "fitted to.",
        "fogcomp compare " + model.file + " OTHER_RUN.csv");
  }
  add_ladder(report, model.model.history);
  report.section("Model");
  report.listing(describe(model.model));
  report.listing(identification);
  for (std::size_t run = 0; run < model.runs.size(); ++run) add_run(report, {model}, run);
  return report;
}

}  // namespace fogcomp::report
