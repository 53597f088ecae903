#include "report/run_section.hpp"

#include <cmath>

#include "evaluation/autocorrelation.hpp"
#include "evaluation/noise_coefficients.hpp"
#include "report/allan_plot.hpp"
#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"

namespace fogcomp::report {
namespace {

using Models = std::vector<ModelOnRuns>;

template <class Value>
std::vector<double> column(const Comparison& comparison, Value value) {
  std::vector<double> values;
  for (const Comparison::Row& row : comparison.rows) values.push_back(value(row));
  return values;
}

const Comparison& on_run(const ModelOnRuns& model, std::size_t run) {
  return model.runs[run].comparison;
}

// One model has the name of what it is; several are told apart by their files.
std::string label(const Models& models, std::size_t model, const char* alone) {
  return models.size() == 1 ? alone : models[model].file;
}

std::string residual_colour(std::size_t model) {
  return model == 0 ? "residual" : part_colour(model + 1);
}

std::optional<double> drift_left(const Comparison& comparison, double rms_dph) {
  if (!comparison.noise_floor_dph) return std::nullopt;
  return floor_removed(rms_dph, *comparison.noise_floor_dph);
}

void add_words(Report& report, const Models& models, std::size_t run) {
  for (const ModelOnRuns& model : models) {
    const std::string name = models.size() == 1 ? "" : model.file + ": ";
    const Comparison& comparison = on_run(model, run);
    const std::string error = error_words(comparison) + " deg/h";
    report.sentence((name.empty() ? as_sentence(error) : name + error + ".") + " " +
                    as_sentence(structure_words(model.runs[run])));
    for (const std::string& remark : remarks(model.runs[run])) {
      report.sentence(as_sentence(name + remark));
    }
    for (const std::string& warning : range_warnings(comparison, model.model)) {
      report.sentence(as_sentence("warning: " + name + warning));
    }
  }
}

void add_segments(Report& report, const Comparison& comparison) {
  Table table{{"segment", "rows", "raw mean", "raw std", "residual mean", "residual std",
               "residual rms", "floor", "drift left"},
              {}};
  const auto add = [&](const Comparison::Segment& segment) {
    if (segment.range.size() == 0) return;
    table.rows.push_back({segment.name, format("%zu", segment.range.size()),
                          dph(segment.raw_mean_dph), dph(segment.raw_std_dph),
                          dph(segment.mean_dph), dph(segment.std_dph), dph(segment.rms_dph),
                          dph(comparison.noise_floor_dph),
                          dph(drift_left(comparison, segment.rms_dph))});
  };
  for (const Comparison::Segment& segment : comparison.segments) add(segment);
  add(comparison.whole);
  report.sentence(
      format("deg/h, means of %.4g s; drift left is √(rms² − floor²).", comparison.row_s));
  report.table(table);
}

// Rms segment by segment: before, then what each model leaves.
void add_before_and_after(Report& report, const Models& models, std::size_t run) {
  const Comparison& first = on_run(models[0], run);
  Bars bars;
  bars.floor = first.noise_floor_dph.value_or(0);
  bars.caption = bars.floor > 0 ? "Error per segment, deg/h; dashed: the noise floor."
                                : "Error per segment, deg/h.";
  bars.keys = {{"before (std)", "measured"}};
  for (std::size_t i = 0; i < models.size(); ++i) {
    bars.keys.push_back({label(models, i, "after (rms)"), residual_colour(i)});
  }
  const auto add = [&](std::size_t segment, bool whole) {
    const auto of = [&](const ModelOnRuns& model) -> const Comparison::Segment& {
      const Comparison& comparison = on_run(model, run);
      return whole ? comparison.whole : comparison.segments[segment];
    };
    const Comparison::Segment& raw = of(models[0]);
    if (raw.range.size() == 0) return;
    Bars::Row row{raw.name, {{raw.raw_std_dph, "measured", dph(raw.raw_std_dph)}}, ""};
    for (std::size_t i = 0; i < models.size(); ++i) {
      const double rms_dph = of(models[i]).rms_dph;
      row.bars.push_back({rms_dph, residual_colour(i), dph(rms_dph)});
    }
    bars.rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < first.segments.size(); ++i) add(i, false);
  add(0, true);
  report.bars(bars);
}

void add_over_time(Report& report, const Models& models, std::size_t run) {
  const Comparison& first = on_run(models[0], run);
  const std::vector<double> time_s =
      column(first, [](const Comparison::Row& row) { return row.time_s; });
  const std::vector<double> degc =
      column(first, [](const Comparison::Row& row) { return row.temperature_degc; });
  const std::vector<double> measured = first.measured_dph();
  std::vector<std::vector<double>> drifts;
  std::vector<std::vector<double>> residuals;
  for (const ModelOnRuns& model : models) {
    drifts.push_back(column(on_run(model, run), [](const auto& row) { return row.drift_dph; }));
    residuals.push_back(on_run(model, run).residuals_dph());
  }
  std::vector<Trace> over{{"measured", "measured", measured}};
  std::vector<Trace> left;
  for (std::size_t i = 0; i < models.size(); ++i) {
    over.push_back(
        {label(models, i, "model"), models.size() == 1 ? "model" : residual_colour(i), drifts[i]});
  }
  for (std::size_t i = models.size(); i-- > 0;) {
    left.push_back({label(models, i, "residual"), residual_colour(i), residuals[i]});
  }
  const TimeAxis axis{time_s, starts_of(first.stretches), format("run %zu", run)};
  report.plot(time_plot("Rate less input rate, the model on top.", "rate, deg/h", axis, over));
  report.plot(
      time_plot("Temperature.", "temperature, degC", axis, {{"temperature", "part5", degc}}));
  report.plot(time_plot("Residual.", "residual, deg/h", axis, left));
}

void add_parts(Report& report, const ModelOnRuns& model, std::size_t run) {
  const Comparison& comparison = on_run(model, run);
  const std::vector<double> time_s =
      column(comparison, [](const Comparison::Row& row) { return row.time_s; });
  std::vector<Trace> parts;
  for (std::size_t i = 0; i < comparison.effects.size(); ++i) {
    constexpr double kConstant = 1e-9;  // deg/h: such a part has no share in any change
    if (comparison.effects[i].std_dph < kConstant) continue;
    parts.push_back(
        {comparison.effects[i].name, part_colour(parts.size()), comparison.parts_dph[i]});
  }
  if (!parts.empty()) {
    report.plot(stacked_plot("What each part of the model does.", "drift, deg/h",
                             {time_s, starts_of(comparison.stretches), format("run %zu", run)},
                             parts));
  }
  Table table{{"part", "mean, deg/h", "std, deg/h", "share of the raw variance"}, {}};
  for (const EffectShare& effect : comparison.effects) {
    table.rows.push_back({effect.name, dph(effect.mean_dph), dph(effect.std_dph),
                          format("%.1f %%", 100 * effect.share)});
  }
  report.sentence(
      "Share: what comes back when a part alone is left out; parts that go together share, so the "
      "shares need not add up to 100 %.");
  report.table(table);
}

Curve bin_means(const char* label, const char* colour) {
  return {label, colour, {}, {}, {}, Look::line};
}

void add_dependences(Report& report, const ModelOnRuns& model, std::size_t run) {
  const Comparison& comparison = on_run(model, run);
  const ResidualAnalysis& analysis = model.runs[run].analysis;
  const std::vector<double> residual = comparison.residuals_dph();
  const std::vector<double> degc =
      column(comparison, [](const Comparison::Row& row) { return row.temperature_degc; });
  const std::vector<double> rate = column(
      comparison, [](const Comparison::Row& row) { return row.temperature_rate_degc_per_min; });
  const std::vector<Branch> branch = branches(degc);

  Plot over_temperature = branch_plot("Residual over temperature.", "temperature, degC",
                                      "residual, deg/h", degc, residual, branch, comparison.row_s);
  Curve heating = bin_means("heating, mean", "heating");
  Curve cooling = bin_means("cooling, mean", "cooling");
  for (const LoopBin& bin : analysis.history.bins) {
    heating.x.push_back(bin.at_degc);
    heating.y.push_back(bin.heating_dph);
    cooling.x.push_back(bin.at_degc);
    cooling.y.push_back(bin.cooling_dph);
  }
  if (!heating.x.empty()) {
    over_temperature.caption += " Lines apart: a loop, which temperature alone cannot model.";
    over_temperature.curves.push_back(std::move(heating));
    over_temperature.curves.push_back(std::move(cooling));
  }
  report.plot(over_temperature);

  Plot over_rate = branch_plot("Residual over temperature rate.", "temperature rate, degC/min",
                               "residual, deg/h", rate, residual, branch, comparison.row_s);
  Curve means = bin_means("mean", "mark");
  for (const ResidualBin& bin : analysis.rate.bins) {
    means.x.push_back(bin.at);
    means.y.push_back(bin.mean_dph);
    means.sigma.push_back(bin.sigma_dph);
  }
  if (over_rate.curves.empty()) return;
  if (!means.x.empty()) over_rate.curves.push_back(std::move(means));
  report.plot(over_rate);
}

void add_noise(Report& report, const ModelOnRuns& model, std::size_t run) {
  const ResidualAnalysis& analysis = model.runs[run].analysis;
  if (!analysis.raw_allan.empty()) {
    report.plot(allan_plot({{"before", "measured", analysis.raw_allan},
                            {"after", "residual", analysis.residual_allan}},
                           fit_noise_coefficients(analysis.residual_allan)));
  }
  constexpr std::size_t kLags = 100;
  const Comparison& comparison = on_run(model, run);
  const std::vector<double> residual = comparison.bridged(comparison.residuals_dph());
  Curve curve{"residual", "residual", {}, {}, {}, Look::line};
  for (std::size_t lag = 1; lag <= std::min(kLags, residual.size() / 4); ++lag) {
    curve.x.push_back(static_cast<double>(lag) * comparison.row_s);
    curve.y.push_back(autocorrelation(residual, comparison.stretches, lag));
  }
  if (curve.x.size() < 2) return;
  Plot plot;
  plot.title = "Autocorrelation of the residual.";
  plot.caption = "White noise stays between the dashed lines 95 times in 100.";
  plot.x_label = "lag, s";
  plot.y_label = "correlation";
  plot.levels = {{"white noise", analysis.white_band}, {"", -analysis.white_band}};
  plot.curves.push_back(std::move(curve));
  report.plot(plot);
}

}  // namespace

std::string run_files(const ModelOnRuns& model) {
  std::string files;
  for (const ModelOnRun& run : model.runs) files += " " + run.comparison.file;
  return files;
}

bool leaves_drift(const ModelOnRun& run) {
  return run.analysis.excess_dph2.has_value();
}

void add_run(Report& report, const std::vector<ModelOnRuns>& models, std::size_t run) {
  report.section(on_run(models[0], run).file);
  add_words(report, models, run);
  add_segments(report, on_run(models[0], run));
  add_before_and_after(report, models, run);
  if (on_run(models[0], run).rows.size() < 2) return;
  add_over_time(report, models, run);
  if (models.size() > 1) report.sentence("What follows is of " + models[0].file + ".");
  add_dependences(report, models[0], run);
  add_parts(report, models[0], run);
  add_noise(report, models[0], run);
}

}  // namespace fogcomp::report
