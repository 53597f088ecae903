#include "report/add_report.hpp"

#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

Text remark(const Addition::RunError& run) {
  return run.holdout ? " (holdout)" : "";
}

void add_errors(Report& report, const Addition& addition) {
  Bars bars;
  bars.quantity = "rms left, deg/h";
  bars.keys = {{"before", "measured"}, {"after", "residual"}};
  bars.caption =
      words(format("What is left of each run, means of %g s, the model refitted to the "
                   "same runs before and after.",
                   addition.model.average_s));
  if (const auto floor = addition.runs[0].noise_floor_dph) {
    bars.floor = *floor;
    bars.caption += " Dashed: the noise floor of the first run.";
  }
  std::vector<std::string> files;
  for (const Addition::RunError& run : addition.runs) files.push_back(run.file);
  const std::vector<std::string> names = short_names(files);
  Table table{{"run", "rms before", "rms after", "drift before", "drift after", "floor"}, {}};
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    const Addition::RunError& run = addition.runs[i];
    const Text name = verbatim(names[i]) + remark(run);
    bars.rows.push_back({name,
                         {{run.rms_before_dph, "measured", number(run.rms_before_dph)},
                          {run.rms_after_dph, "residual", number(run.rms_after_dph)}}});
    const auto drift = [&](double rms_dph) {
      return run.noise_floor_dph ? number(floor_removed(rms_dph, *run.noise_floor_dph)) : Text("-");
    };
    table.rows.push_back({name, number(run.rms_before_dph), number(run.rms_after_dph),
                          drift(run.rms_before_dph), drift(run.rms_after_dph),
                          dph(run.noise_floor_dph)});
  }
  report.section("Before and after");
  report.bars(bars);
  report.table(table);
  for (const HalfTest& half : addition.halves) {
    report.sentence(words(as_sentence(half_words(half))));
  }
}

Text before_and_after(const Addition::RunError& run) {
  return "Rms " + number(run.rms_before_dph) + " deg/h before, " + number(run.rms_after_dph) +
         " after.";
}

void add_run(Report& report, const Addition::RunError& run, const std::string& group) {
  const std::vector<double> degc = run.after.rows.temperatures_degc();
  const std::vector<double> before = run.before.residuals_dph();
  const std::vector<double> after = run.after.residuals_dph();
  const TimeAxis axis = time_axis(run.after, group);
  report.file_section(run.file, remark(run));
  Plot residual = time_plot("Residual.", "residual, deg/h", axis,
                            {{"before", "measured", before}, {"after", "residual", after}});
  residual.caption = before_and_after(run);
  report.plot(residual);
  report.plot(temperature_plot(axis, degc));
  const std::vector<Branch> branch = branches(degc);
  if (!ever_moves(branch)) return;
  const auto over_temperature = [&](const Text& title, const std::vector<double>& values) {
    report.plot(branch_plot(title, "temperature, degC", "residual, deg/h", degc, values, branch));
  };
  over_temperature("Residual over temperature, before.", before);
  over_temperature("Residual over temperature, after.", after);
}

}  // namespace

Report add_report(const Addition& addition, const std::string& model, const std::string& written) {
  const EffectTerm& term = addition.model.terms[addition.changed];
  std::vector<std::string> names;
  for (const EffectTerm& one : addition.model.terms) names.push_back(one.name);
  std::string runs;
  for (const Addition::RunError& run : addition.runs) {
    if (!run.holdout) runs += " " + run.file;
  }
  Report report(
      "fogcomp add " + model + " " + term.name + runs,
      words(term.name + (addition.accepted ? " accepted: " : " refused: ") + addition.reason + ".",
            names));
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
    report.sentence("Note: " + words(as_sentence(warning), names));
  }
  add_errors(report, addition);
  for (std::size_t i = 0; i < addition.runs.size(); ++i) {
    add_run(report, addition.runs[i], format("run %zu", i));
  }
  return report;
}

}  // namespace fogcomp::report
