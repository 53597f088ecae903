#include "findings/allan_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fogcomp::findings {
namespace {

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
