#include "report/add_report.hpp"

#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

void add_errors(Report& report, const Addition& addition) {
  Bars bars;
  bars.keys = {{"before", "measured"}, {"after", "residual"}};
  bars.caption = format("deg/h, rms of %g s means.", addition.model.average_s);
  if (const auto floor = addition.runs[0].noise_floor_dph) {
    bars.floor = *floor;
    bars.caption += " Dashed: the noise floor of the first run.";
  }
  Table table{{"run", "before", "after", "floor", "drift before", "drift after"}, {}};
  for (const Addition::RunError& run : addition.runs) {
    const std::string name = run.file + (run.holdout ? " (holdout)" : "");
    bars.rows.push_back({name,
                         {{run.rms_before_dph, "measured", dph(run.rms_before_dph)},
                          {run.rms_after_dph, "residual", dph(run.rms_after_dph)}},
                         ""});
    const auto drift = [&](double rms_dph) {
      return run.noise_floor_dph ? dph(floor_removed(rms_dph, *run.noise_floor_dph)) : "-";
    };
    table.rows.push_back({name, dph(run.rms_before_dph), dph(run.rms_after_dph),
                          dph(run.noise_floor_dph), drift(run.rms_before_dph),
                          drift(run.rms_after_dph)});
  }
  report.section("Before and after");
  report.bars(bars);
  report.table(table);
  for (const HalfTest& half : addition.halves) report.sentence(as_sentence(half_words(half)));
}

void add_run(Report& report, const Addition::RunError& run, const std::string& group) {
  std::vector<double> time_s;
  std::vector<double> degc;
  for (const Comparison::Row& row : run.after.rows) {
    time_s.push_back(row.time_s);
    degc.push_back(row.temperature_degc);
  }
  const std::vector<double> before = run.before.residuals_dph();
  const std::vector<double> after = run.after.residuals_dph();
  const TimeAxis axis{time_s, starts_of(run.after.stretches), group};
  report.section(run.file + (run.holdout ? " (holdout)" : ""));
  report.plot(time_plot("Residual.", "residual, deg/h", axis,
                        {{"before", "measured", before}, {"after", "residual", after}}));
  report.plot(
      time_plot("Temperature.", "temperature, degC", axis, {{"temperature", "part5", degc}}));
  const std::vector<Branch> branch = branches(degc);
  report.plot(branch_plot("Residual over temperature, before.", "temperature, degC",
                          "residual, deg/h", degc, before, branch, run.after.row_s));
  report.plot(branch_plot("Residual over temperature, after.", "temperature, degC",
                          "residual, deg/h", degc, after, branch, run.after.row_s));
}

}  // namespace

Report add_report(const Addition& addition, const std::string& model, const std::string& written) {
  const EffectTerm& term = addition.model.terms[addition.changed];
  std::string runs;
  for (const Addition::RunError& run : addition.runs) {
    if (!run.holdout) runs += " " + run.file;
  }
  Report report(
      "fogcomp add " + model + " " + term.name + runs,
      term.name + (addition.accepted ? " accepted: " : " refused: ") + addition.reason + ".");
  if (written.empty()) {
    report.next("nothing was written; ask what else it could be.",
                "fogcomp diagnose " + model + runs);
  } else {
    report.next("look again at what the new model leaves.", "fogcomp diagnose " + written + runs);
  }
  Model changed;
  changed.terms = {term};
  report.listing(describe(changed));
  for (const std::string& warning : addition.fit.identified.warnings) {
    report.sentence(as_sentence("note: " + warning));
  }
  add_errors(report, addition);
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    add_run(report, addition.runs[i], format("run %zu", i));
  }
  return report;
}

}  // namespace fogcomp::report
