#include "findings/residual_plots.hpp"

#include <algorithm>
#include <cmath>

#include "findings/allan_plot.hpp"
#include "findings/figures.hpp"
#include "noise/autocorrelation.hpp"
#include "noise/noise_coefficients.hpp"
#include "noise/spectral_density.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

Plot band_plot(const compare::ModelOnRun& judged) {
  Plot plot;
  const std::optional<compare::PredictiveBand>& band = judged.band;
  if (!band) return plot;
  Curve residual{"residual", "residual", band->residual_dph};
  residual.look = Look::points;
  Curve above{"2 sigma", "model", {}};
  above.look = Look::dashed;
  Curve below = above;
  plot.title =
      words(format("Means of the residual over %.3g min, and the band that the model promises.",
                   band->row_s / kSecondsPerMinute));
  plot.x_label = "time, h";
  plot.y_label = "residual, deg/h";
  for (std::size_t i = 0; i < band->time_s.size(); ++i) {
    plot.x.push_back(band->time_s[i] / kSecondsPerHour);
    above.y.push_back(2 * band->sigma_dph[i]);
    below.y.push_back(-2 * band->sigma_dph[i]);
  }
  plot.curves = {above, below, residual};
  plot.caption = words(format("Within 1 sigma: %.0f %%, within 2: %.0f %%.",
                              100 * band->share_within(1), 100 * band->share_within(2)));
  return plot;
}

Plot soaks_plot(const Models& models, std::size_t run) {
  const compare::ResidualAnalysis& best = models[0]->runs[run].analysis;
  if (best.raw_allan.empty()) return {};
  const std::vector<Text> names = labels(models, "after");
  std::vector<AllanCurve> curves{{"before", "measured", best.raw_allan}};
  for (std::size_t i = models.size(); i-- > 0;) {
    curves.push_back({names[i], residual_colour(i), models[i]->runs[run].analysis.residual_allan});
  }
  return allan_plot(curves, noise::fit_noise_coefficients(best.residual_allan));
}

// A curve of what is measured, then one of each residual, the best on top. `curve_of` gives x, y
// and sigma of the values of each row.
template <class CurveOf>
void before_and_after(Plot& plot, const Models& models, std::size_t run, const CurveOf& curve_of) {
  const std::vector<Text> names = labels(models, "after");
  const auto add = [&](const Text& name, const std::string& colour, Look look,
                       const compare::Comparison& comparison, const std::vector<double>& values) {
    Curve curve = curve_of(comparison, comparison.bridged(values));
    curve.label = name;
    curve.colour = colour;
    curve.look = look;
    if (curve.x.size() > 1) plot.curves.push_back(std::move(curve));
  };
  const compare::Comparison& best = on_run(*models[0], run);
  add("before", "measured", Look::line, best, best.measured_dph());
  for (std::size_t i = models.size(); i-- > 0;) {
    const compare::Comparison& comparison = on_run(*models[i], run);
    add(names[i], residual_colour(i), look_of(i), comparison, comparison.residuals_dph());
  }
}

Plot whole_run_plot(const Models& models, std::size_t run) {
  Plot plot;
  plot.kind = Plot::Kind::log_log;
  plot.title = "Allan deviation of the whole run.";
  plot.x_label = "averaging time, s";
  plot.y_label = "Allan deviation, deg/h";
  plot.caption = "Ramps included: before, long times have the drift. Bars: one standard deviation.";
  before_and_after(plot, models, run, [](const compare::Comparison& of, const auto& values) {
    Curve curve;
    for (const noise::AllanPoint& point :
         noise::allan_deviation(values, of.rows.stretches(), of.rows.row_s)) {
      curve.x.push_back(point.tau_s);
      curve.y.push_back(point.sigma);
      curve.sigma.push_back(point.one_sigma);
    }
    return curve;
  });
  return plot;
}

Plot spectrum_plot(const Models& models, std::size_t run) {
  Plot plot;
  plot.kind = Plot::Kind::log_log;
  plot.title = "Spectrum of the whole run.";
  plot.x_label = "frequency, Hz";
  plot.y_label = "amplitude density, deg/h/sqrt(Hz)";
  plot.caption = "White noise is level, and a line is a peak. Bars: one standard deviation.";
  before_and_after(plot, models, run, [](const compare::Comparison& of, const auto& values) {
    Curve curve;
    for (const noise::SpectralPoint& point :
         noise::spectral_density(values, of.rows.stretches(), of.rows.row_s)) {
      curve.x.push_back(point.frequency_hz);
      curve.y.push_back(point.density);
      curve.sigma.push_back(point.one_sigma);
    }
    return curve;
  });
  return plot;
}

// The residual in the order of its size, over what a normal distribution has there: evenly along
// it, so that the few values at the ends are as plain as the many in the middle.
Curve quantiles_of(const std::vector<double>& sorted) {
  constexpr int kEnd = 100;  // points on either side of the middle
  constexpr double kStep = 0.05;
  const auto rows = static_cast<double>(sorted.size());
  Curve curve;
  for (int i = -kEnd; i <= kEnd; ++i) {
    const double quantile = kStep * i;
    const double row = std::erfc(-quantile / std::sqrt(2.0)) / 2 * rows - 0.5;
    if (row < 0 || row > rows - 1) continue;
    curve.x.push_back(quantile);
    curve.y.push_back(sorted[static_cast<std::size_t>(std::lround(row))]);
  }
  return curve;
}

Plot quantile_plot(const Models& models, std::size_t run) {
  constexpr std::size_t kMinRows = 30;
  Plot plot;
  plot.title = "Residual against a normal distribution.";
  plot.x_label = "quantile of the normal distribution, standard deviations";
  plot.y_label = "residual, deg/h";
  plot.caption = "Noise lies on the dashed line. Ends that bend off it: more large values.";
  const std::vector<Text> names = labels(models, "residual");
  for (std::size_t i = models.size(); i-- > 0;) {
    const compare::Comparison& comparison = on_run(*models[i], run);
    std::vector<double> values = comparison.counted(comparison.residuals_dph());
    if (values.size() < kMinRows) return {};
    std::sort(values.begin(), values.end());
    Curve curve = quantiles_of(values);
    curve.label = names[i];
    curve.colour = residual_colour(i);
    curve.look = Look::points;
    plot.curves.push_back(std::move(curve));
  }
  const compare::Comparison::SegmentError& whole = on_run(*models[0], run).whole;
  Curve line{"normal", "mark", {}, {}, {}, Look::dashed};
  for (const double end : {plot.curves.back().x.front(), plot.curves.back().x.back()}) {
    line.x.push_back(end);
    line.y.push_back(whole.mean_dph + whole.std_dph * end);
  }
  plot.curves.push_back(std::move(line));
  return plot;
}

constexpr int kBins = 40;       // of a histogram
constexpr double kBinsEnd = 4;  // standard deviations on either side of the mean
constexpr double kPerBin = 2 * kBinsEnd / kBins;

// Rows in each bin, in steps.
Curve histogram_of(const std::vector<double>& values, double mean, double sigma) {
  std::vector<double> rows(kBins, 0);
  for (const double value : values) {
    const double bin = std::floor(((value - mean) / sigma + kBinsEnd) / kPerBin);
    if (bin >= 0 && bin < kBins) ++rows[static_cast<std::size_t>(bin)];
  }
  Curve curve;
  for (int edge = 0; edge <= kBins; ++edge) {
    const double x = mean + (edge * kPerBin - kBinsEnd) * sigma;
    for (const int bin : {edge - 1, edge}) {
      curve.x.push_back(x);
      curve.y.push_back(bin < 0 || bin == kBins ? 0 : rows[static_cast<std::size_t>(bin)]);
    }
  }
  return curve;
}

// As many rows of a normal distribution.
Curve normal_curve(std::size_t rows, double mean, double sigma) {
  Curve curve{"normal", "mark", {}, {}, {}, Look::dashed};
  for (int i = -kBins; i <= kBins; ++i) {
    const double deviations = kBinsEnd * i / kBins;
    curve.x.push_back(mean + deviations * sigma);
    curve.y.push_back(static_cast<double>(rows) * kPerBin * std::exp(-deviations * deviations / 2) /
                      std::sqrt(2 * kPi));
  }
  return curve;
}

Plot histogram_plot(const Models& models, std::size_t run) {
  Plot plot;
  plot.title = "Distribution of the residual.";
  plot.x_label = "residual, deg/h";
  plot.y_label = "rows";
  const compare::Comparison::SegmentError& whole = on_run(*models[0], run).whole;
  if (!(whole.std_dph > 0)) return {};
  const std::vector<Text> names = labels(models, "residual");
  std::size_t rows = 0;
  for (std::size_t i = models.size(); i-- > 0;) {
    const compare::Comparison& comparison = on_run(*models[i], run);
    const std::vector<double> values = comparison.counted(comparison.residuals_dph());
    rows = values.size();
    if (rows < kBins) return {};
    Curve curve = histogram_of(values, whole.mean_dph, whole.std_dph);
    curve.label = names[i];
    curve.colour = residual_colour(i);
    curve.look = look_of(i);
    plot.curves.push_back(std::move(curve));
  }
  plot.curves.push_back(normal_curve(rows, whole.mean_dph, whole.std_dph));
  plot.caption = "Dashed: a normal distribution of the same mean and standard deviation.";
  return plot;
}

Plot correlation_plot(const Models& models, std::size_t run) {
  constexpr std::size_t kLags = 100;
  const std::vector<Text> names = labels(models, "residual");
  Plot plot;
  plot.title = "Autocorrelation of the residual.";
  plot.x_label = "lag, s";
  plot.y_label = "correlation";
  for (std::size_t i = models.size(); i-- > 0;) {
    const compare::Comparison& comparison = on_run(*models[i], run);
    const std::vector<double> residual = comparison.bridged(comparison.residuals_dph());
    Curve curve{names[i], residual_colour(i), {}, {}, {}, look_of(i)};
    for (std::size_t lag = 1; lag <= std::min(kLags, residual.size() / 4); ++lag) {
      curve.x.push_back(static_cast<double>(lag) * comparison.rows.row_s);
      curve.y.push_back(noise::autocorrelation(residual, comparison.rows.stretches(), lag));
    }
    if (curve.x.size() < 2) return {};
    plot.curves.push_back(std::move(curve));
  }
  const double band = models[0]->runs[run].analysis.white_band;
  const Curve& best = plot.curves.back();
  plot.caption =
      words(format("%.2f from one row to the next; white noise stays between the dashed "
                   "lines, +-%.2f, 95 times in 100.",
                   best.y[0], band));
  plot.levels = {{"white noise", band}, {"", -band}};
  return plot;
}

// The means of the residual where the table was, relative to the rate; where it nearly stood, the
// quotient says nothing.
Plot scale_factor_plot(const compare::ModelOnRun& judged) {
  constexpr double kStands = 0.05;  // of the largest rate
  constexpr double kPpm = 1e6;
  Plot plot;
  plot.title = "Scale-factor error left.";
  plot.x_label = "input rate, deg/h";
  plot.y_label = "residual per input rate, ppm";
  plot.caption = "A point for each rate of the table. Bars: one standard deviation.";
  const auto& inputs = judged.comparison.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].input != fog::Input::input_rate) continue;
    double largest = 0;
    for (const double rate : inputs[i].values) largest = std::max(largest, std::fabs(rate));
    Curve curve{"residual", "residual", {}, {}, {}, Look::points};
    for (const compare::ResidualBin& bin : judged.analysis.inputs[i].bins) {
      if (std::fabs(bin.at) <= kStands * largest) continue;
      curve.x.push_back(bin.at);
      curve.y.push_back(kPpm * bin.mean_dph / bin.at);
      curve.sigma.push_back(kPpm * bin.sigma_dph / std::fabs(bin.at));
    }
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

std::vector<Plot> residual_plots(const Models& models, std::size_t run) {
  std::vector<Plot> plots{band_plot(models[0]->runs[run]), soaks_plot(models, run),
                          whole_run_plot(models, run),     spectrum_plot(models, run),
                          histogram_plot(models, run),     quantile_plot(models, run),
                          correlation_plot(models, run),   scale_factor_plot(models[0]->runs[run])};
  plots.erase(std::remove_if(plots.begin(), plots.end(),
                             [](const Plot& plot) { return plot.curves.empty(); }),
              plots.end());
  return plots;
}

}  // namespace fogcomp::findings
