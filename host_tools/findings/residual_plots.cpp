#include <algorithm>
#include <cmath>

#include "findings/run_plots.hpp"
#include "findings/run_section.hpp"
#include "findings/text.hpp"
#include "noise/autocorrelation.hpp"
#include "noise/noise_coefficients.hpp"
#include "noise/spectral_density.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

Plot band_plot(const compare::ModelOnRun& judged) {
  const std::optional<compare::PredictiveBand>& band = judged.band;
  if (!band) return {};
  Plot plot{
      words(format("Means of the residual over %.3g min, and the band that the model promises.",
                   band->row_s / kSecondsPerMinute)),
      "time, h",
      "residual, deg/h",
      {}};
  Curve above{"2 sigma", "model", {}, {}, {}, Look::dashed};
  Curve below = above;
  for (std::size_t i = 0; i < band->time_s.size(); ++i) {
    plot.x.push_back(band->time_s[i] / kSecondsPerHour);
    above.y.push_back(2 * band->sigma_dph[i]);
    below.y.push_back(-2 * band->sigma_dph[i]);
  }
  plot.curves = {above, below, {"residual", "residual", band->residual_dph, {}, {}, Look::points}};
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

// `curve_of` of each model's residual on the run, the best on top; `alone`: the label of a single
// model. None at all if one has fewer than two points.
template <class CurveOf>
std::vector<Curve> curves_of(const Models& models, std::size_t run, const Text& alone,
                             const CurveOf& curve_of) {
  const std::vector<Text> names = labels(models, alone);
  std::vector<Curve> curves;
  for (std::size_t i = models.size(); i-- > 0;) {
    const compare::Comparison& comparison = on_run(*models[i], run);
    Curve curve = curve_of(comparison, comparison.residuals_dph());
    if (curve.x.size() < 2) return {};
    curve.label = names[i];
    curve.colour = residual_colour(i);
    curve.look = look_of(i);
    curves.push_back(std::move(curve));
  }
  return curves;
}

// Of the whole run, first what is measured, then the residuals, on logarithmic axes: members of the
// points that `points_of` gives.
template <class Point>
Plot before_and_after(const Models& models, std::size_t run, Plot plot,
                      std::vector<Point> (*points_of)(const std::vector<double>& values,
                                                      const std::vector<recording::RowRange>& rows,
                                                      double row_s),
                      double Point::*x, double Point::*y) {
  const auto curve_of = [&](const compare::Comparison& of, const std::vector<double>& values) {
    Curve curve{"before", "measured", {}};
    for (const Point& point : points_of(of.bridged(values), of.rows.stretches(), of.rows.row_s)) {
      curve.x.push_back(point.*x);
      curve.y.push_back(point.*y);
      curve.sigma.push_back(point.one_sigma);
    }
    return curve;
  };
  plot.kind = Plot::Kind::log_log;
  plot.curves = curves_of(models, run, "after", curve_of);
  if (plot.curves.empty()) return plot;
  const compare::Comparison& best = on_run(*models[0], run);
  plot.curves.insert(plot.curves.begin(), curve_of(best, best.measured_dph()));
  return plot;
}

Plot whole_run_plot(const Models& models, std::size_t run) {
  Plot plot{"Allan deviation of the whole run.", "averaging time, s", "Allan deviation, deg/h", {}};
  plot.caption = "Ramps included: before, long times have the drift. Bars: one standard deviation.";
  return before_and_after(models, run, std::move(plot), noise::allan_deviation,
                          &noise::AllanPoint::tau_s, &noise::AllanPoint::sigma);
}

Plot spectrum_plot(const Models& models, std::size_t run) {
  Plot plot{"Spectrum of the whole run.", "frequency, Hz", "amplitude density, deg/h/sqrt(Hz)", {}};
  plot.caption = "White noise is level, and a line is a peak. Bars: one standard deviation.";
  return before_and_after(models, run, std::move(plot), noise::spectral_density,
                          &noise::SpectralPoint::frequency_hz, &noise::SpectralPoint::density);
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
  Plot plot{"Residual against a normal distribution.",
            "quantile of the normal distribution, standard deviations", "residual, deg/h",
            curves_of(models, run, "residual",
                      [](const compare::Comparison& of, const std::vector<double>& residual) {
                        std::vector<double> values = of.counted(residual);
                        std::sort(values.begin(), values.end());
                        return values.size() < kMinRows ? Curve() : quantiles_of(values);
                      })};
  if (plot.curves.empty()) return plot;
  for (Curve& curve : plot.curves) curve.look = Look::points;
  plot.caption = "Noise lies on the dashed line. Ends that bend off it: more large values.";
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
  const compare::Comparison::SegmentError& whole = on_run(*models[0], run).whole;
  if (!(whole.std_dph > 0)) return {};
  std::size_t rows = 0;
  Plot plot{"Distribution of the residual.", "residual, deg/h", "rows",
            curves_of(models, run, "residual",
                      [&](const compare::Comparison& of, const std::vector<double>& residual) {
                        const std::vector<double> values = of.counted(residual);
                        rows = values.size();
                        return rows < kBins ? Curve()
                                            : histogram_of(values, whole.mean_dph, whole.std_dph);
                      })};
  if (plot.curves.empty()) return plot;
  plot.curves.push_back(normal_curve(rows, whole.mean_dph, whole.std_dph));
  plot.caption = "Dashed: a normal distribution of the same mean and standard deviation.";
  return plot;
}

Curve correlations_of(const compare::Comparison& comparison,
                      const std::vector<double>& residual_dph) {
  constexpr std::size_t kLags = 100;
  const std::vector<double> residual = comparison.bridged(residual_dph);
  Curve curve;
  for (std::size_t lag = 1; lag <= std::min(kLags, residual.size() / 4); ++lag) {
    curve.x.push_back(static_cast<double>(lag) * comparison.rows.row_s);
    curve.y.push_back(noise::autocorrelation(residual, comparison.rows.stretches(), lag));
  }
  return curve;
}

Plot correlation_plot(const Models& models, std::size_t run) {
  Plot plot{"Autocorrelation of the residual.", "lag, s", "correlation",
            curves_of(models, run, "residual", correlations_of)};
  if (plot.curves.empty()) return plot;
  const double band = models[0]->runs[run].analysis.white_band;
  plot.caption =
      words(format("%.2f from one row to the next; white noise stays between the dashed "
                   "lines, +-%.2f, 95 times in 100.",
                   plot.curves.back().y[0], band));
  plot.levels = {{"white noise", band}, {"", -band}};
  return plot;
}

// The means of the residual where the table was, relative to the rate; where it nearly stood, the
// quotient says nothing.
Plot scale_factor_plot(const compare::ModelOnRun& judged) {
  constexpr double kStands = 0.05;  // of the largest rate
  constexpr double kPpm = 1e6;
  Plot plot{"Scale-factor error left.", "input rate, deg/h", "residual per input rate, ppm", {}};
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
