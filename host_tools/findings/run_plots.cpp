#include "findings/run_plots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "findings/text.hpp"
#include "findings/thinning.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

std::vector<const std::vector<double>*> columns_of(const std::vector<Trace>& traces) {
  std::vector<const std::vector<double>*> columns;
  for (const Trace& trace : traces) columns.push_back(&trace.values);
  return columns;
}

const char* shade_of(recording::SegmentKind kind) {
  switch (kind) {
    case recording::SegmentKind::ramp_up:
      return "heating";
    case recording::SegmentKind::ramp_down:
      return "cooling";
    case recording::SegmentKind::soak:
      break;
  }
  return "";
}

Plot plot_over_time(const Text& title, const Text& y_label, const TimeAxis& axis,
                    const std::vector<double>& time_s) {
  Plot plot{title, "time since power-on, h", y_label, {}};
  plot.group = axis.group;
  for (const double time : time_s) plot.x.push_back(time / kSecondsPerHour);
  plot.bands = bands_of(axis.segments);
  return plot;
}

struct Term {
  const char* label;
  const char* colour;
  const std::optional<noise::NoiseCoefficient>& coefficient;
};

// In the order of noise::AllanModel.
std::vector<Term> terms_of(const noise::NoiseCoefficients& noise) {
  return {
      {"quantization Q, slope -1", "part4", noise.quantization_deg},
      {"angle random walk N, slope -1/2", "part3", noise.angle_random_walk_dprh},
      {"bias instability B, slope 0", "part5", noise.bias_instability_dph},
      {"rate random walk K, slope +1/2", "part6", noise.rate_random_walk_dphrh},
      {"rate ramp R, slope +1", "part7", noise.rate_ramp_dphh},
  };
}

// A slope is drawn where it contributes to the curve.
constexpr double kMinShareOfSum = 0.02;

Text seen(const std::vector<Curve>& slopes) {
  const Text bars = " Bars: one standard deviation.";
  if (slopes.empty()) return "No slope of IEEE Std 952 stands out." + bars;
  Text text = "These data show ";
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    text += (i > 0 ? " and " : "") + slopes[i].label;
  }
  return text + ": dashed." + bars;
}

// Slopes of the fitted coefficients over these times.
std::vector<Curve> slopes_of(const noise::NoiseCoefficients& fitted,
                             const std::vector<double>& tau_s) {
  std::vector<Curve> slopes;
  const std::vector<Term> terms = terms_of(fitted);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (!terms[i].coefficient) continue;
    Curve slope{terms[i].label, terms[i].colour, {}, tau_s, {}, Look::dashed};
    for (const double tau : tau_s) {
      slope.y.push_back(
          noise::sigma_of_term(static_cast<Eigen::Index>(i), terms[i].coefficient->value, tau));
    }
    slopes.push_back(std::move(slope));
  }
  return slopes;
}

}  // namespace

std::vector<std::size_t> starts_of(const std::vector<recording::RowRange>& stretches) {
  std::vector<std::size_t> starts;
  for (const recording::RowRange& stretch : stretches) starts.push_back(stretch.first);
  return starts;
}

TimeAxis time_axis(const compare::Comparison& comparison, const std::string& group) {
  return {comparison.rows.time_s,
          starts_of(comparison.rows.stretches()),
          group,
          {comparison.segments.begin(), comparison.segments.end()}};
}

std::vector<Band> bands_of(const std::vector<recording::Segment>& segments) {
  std::vector<Band> bands;
  for (const recording::Segment& segment : segments) {
    bands.push_back({verbatim(segment.name), segment.start_s / kSecondsPerHour,
                     segment.end_s / kSecondsPerHour, shade_of(segment.kind)});
  }
  return bands;
}

std::string part_colour(std::size_t i) {
  constexpr std::size_t kColours = 8;
  return format("part%zu", i % kColours + 1);
}

Plot time_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
               const std::vector<Trace>& traces) {
  Curves curves = min_and_max(axis.time_s, columns_of(traces), axis.stretch_starts);
  Plot plot = plot_over_time(title, y_label, axis, curves.x);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    Curve curve{traces[i].label, traces[i].colour, std::move(curves.y[i])};
    curve.look = traces[i].look;
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

Plot temperature_plot(const TimeAxis& axis, const std::vector<double>& temperature_degc) {
  Plot plot = time_plot("Temperature.", "temperature, degC", axis,
                        {{"temperature", "part5", temperature_degc}});
  const auto [min, max] = std::minmax_element(temperature_degc.begin(), temperature_degc.end());
  const auto soaks = std::count_if(axis.segments.begin(), axis.segments.end(),
                                   [](const recording::Segment& segment) {
                                     return segment.kind == recording::SegmentKind::soak;
                                   });
  const auto ramps = static_cast<std::ptrdiff_t>(axis.segments.size()) - soaks;
  plot.caption =
      words(format("%.1f to %.1f degC; soaks: %td, ramps: %td.", *min, *max, soaks, ramps));
  return plot;
}

Plot stacked_plot(const Text& title, const Text& y_label, const TimeAxis& axis,
                  const std::vector<Trace>& traces) {
  Curves curves = column_means(axis.time_s, columns_of(traces), axis.stretch_starts);
  Plot plot = plot_over_time(title, y_label, axis, curves.x);
  plot.kind = Plot::Kind::stacked;
  plot.caption = "Each less its mean over the run.";
  std::vector<double> sum(curves.x.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const std::vector<double>& all = traces[i].values;
    const double mean =
        std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
    for (std::size_t row = 0; row < sum.size(); ++row) {
      curves.y[i][row] -= mean;
      sum[row] += curves.y[i][row];
    }
    plot.curves.push_back({traces[i].label, traces[i].colour, std::move(curves.y[i])});
  }
  plot.curves.push_back({"all together", "mark", std::move(sum), {}, {}, Look::dashed});
  return plot;
}

Plot branch_plot(const Text& title, const Text& x_label, const Text& y_label,
                 const std::vector<double>& x, const std::vector<double>& y,
                 const std::vector<compare::Branch>& branch) {
  const std::size_t per_point = rows_per_point(x.size());
  Plot plot{title, x_label, y_label, {}};
  const auto add = [&](const Text& label, const char* colour, compare::Branch wanted) {
    Cloud cloud = thinned(x, y, branch, wanted, per_point);
    if (cloud.x.empty()) return;
    plot.curves.push_back({label, colour, std::move(cloud.y), std::move(cloud.x), {}, Look::cloud});
  };
  add("heating", "heating", compare::Branch::heating);
  add("cooling", "cooling", compare::Branch::cooling);
  add(plot.curves.empty() ? "temperature at rest" : "before the first movement", "measured",
      compare::Branch::none);
  return plot;
}

bool ever_moves(const std::vector<compare::Branch>& branch) {
  return std::any_of(branch.begin(), branch.end(),
                     [](compare::Branch one) { return one != compare::Branch::none; });
}

Curve bin_means(const std::vector<compare::ResidualBin>& bins) {
  Curve means{"mean", "mark", {}};
  for (const compare::ResidualBin& bin : bins) {
    means.x.push_back(bin.at);
    means.y.push_back(bin.mean_dph);
    means.sigma.push_back(bin.sigma_dph);
  }
  return means;
}

Plot with_loop(Plot over_temperature, const compare::Loop& loop) {
  const compare::LoopBin* const widest = loop.widest();
  if (widest == nullptr) return over_temperature;
  Curve heating{"heating, mean", "heating", {}};
  Curve cooling{"cooling, mean", "cooling", {}};
  for (const compare::LoopBin& bin : loop.bins) {
    heating.x.push_back(bin.at_degc);
    heating.y.push_back(bin.heating_dph);
    cooling.x.push_back(bin.at_degc);
    cooling.y.push_back(bin.cooling_dph);
  }
  over_temperature.curves.push_back(std::move(heating));
  over_temperature.curves.push_back(std::move(cooling));
  if (!loop.test.structured()) return over_temperature;
  over_temperature.caption +=
      words(" Heating less cooling " + with_sigma(widest->width_dph(), widest->sigma_dph) +
            format(" deg/h at %.0f degC: a loop, which temperature alone cannot model.",
                   widest->at_degc));
  return over_temperature;
}

Plot allan_plot(const std::vector<AllanCurve>& curves, const noise::NoiseCoefficients& fitted) {
  Plot plot{"Allan deviation in soaks.", "averaging time, s", "Allan deviation, deg/h", {}};
  plot.kind = Plot::Kind::log_log;
  for (const AllanCurve& curve : curves) {
    Curve points{curve.label, curve.colour, {}, {}, {}, Look::points};
    for (const noise::AllanPoint& point : curve.points) {
      points.x.push_back(point.tau_s);
      points.y.push_back(point.sigma);
      points.sigma.push_back(point.one_sigma);
    }
    plot.curves.push_back(std::move(points));
  }
  const std::vector<double> tau_s = plot.curves.back().x;
  std::vector<double> sum(tau_s.size());
  std::vector<Curve> slopes = slopes_of(fitted, tau_s);
  for (const Curve& slope : slopes) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += slope.y[i] * slope.y[i];
  }
  plot.caption = seen(slopes);
  if (slopes.empty()) return plot;
  for (double& square : sum) square = std::sqrt(square);
  for (Curve& slope : slopes) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (slope.y[i] < kMinShareOfSum * sum[i])
        slope.y[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (slopes.size() > 1) {
    plot.curves.push_back({"their sum", "mark", sum, tau_s, {}, Look::line});
  }
  for (Curve& slope : slopes) plot.curves.push_back(std::move(slope));
  return plot;
}

}  // namespace fogcomp::findings
