#include "diagnosis/late_ripple.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "diagnosis/forms.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/evidence.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr std::size_t kLags = 32;  // a fifth apart
// Turns per degC, as polarization_ripple has them; half a turn over 100 degC between neighbours.
constexpr double kMinFrequency = 1 / 60.0;
constexpr double kMaxFrequency = 1 / 2.0;
constexpr std::size_t kFrequencies = 96;
// Bounds of the fit's search, relative to the best of the grid.
// A narrow search does not leave the ripple where only some of the rows are fitted; the wide one is
// for a lag that the rest of what is missing has displaced.
constexpr std::array<double, 2> kLagRanges{4, 16};
constexpr double kPeriodRange = 1.15;

double lag_of(std::size_t i) {
  const double share = static_cast<double>(i) / (kLags - 1);
  return kShortestLag_s * std::pow(kLongestLag_s / kShortestLag_s, share);
}

constexpr double kFrequencyStep = (kMaxFrequency - kMinFrequency) / (kFrequencies - 1);

struct Ripple {
  double lag_s = 0;
  double period_degc = 0;
  double chi2_drop = 0;
};

// Sums of left * exp(2 pi i f T) for all frequencies, turning on from one to the next.
Ripple best_period(const Eigen::VectorXd& temperature, const Eigen::VectorXd& left) {
  std::vector<std::complex<double>> sums(kFrequencies);
  for (Eigen::Index row = 0; row < left.size(); ++row) {
    const double angle = 2 * M_PI * temperature[row];
    std::complex<double> phasor = left[row] * std::polar(1.0, angle * kMinFrequency);
    const std::complex<double> turn = std::polar(1.0, angle * kFrequencyStep);
    for (std::complex<double>& sum : sums) {
      sum += phasor;
      phasor = {phasor.real() * turn.real() - phasor.imag() * turn.imag(),
                phasor.real() * turn.imag() + phasor.imag() * turn.real()};
    }
  }
  const auto best = std::max_element(sums.begin(), sums.end(), [](const auto& a, const auto& b) {
    return std::norm(a) < std::norm(b);
  });
  const auto number = static_cast<double>(best - sums.begin());
  return {0, 1 / (kMinFrequency + number * kFrequencyStep),
          2 * std::norm(*best) / static_cast<double>(left.size())};
}

}  // namespace

std::vector<std::string> find_late_ripples(const series::SignalSeries& series,
                                           const std::vector<model::EffectTerm>& terms,
                                           const Eigen::VectorXd& left) {
  std::vector<Ripple> ripples(kLags);
  for_each_index(kLags, [&](std::size_t i) {
    const double lag_s = lag_of(i);
    const model::EffectTerm late = model::expression_term(format("late = lag(T,%.6g)", lag_s));
    ripples[i] = best_period(series.regressors(late).col(0), left);
    ripples[i].lag_s = lag_s;
  });
  const Ripple best =
      *std::max_element(ripples.begin(), ripples.end(),
                        [](const Ripple& a, const Ripple& b) { return a.chi2_drop < b.chi2_drop; });
  const double excess = left.squaredNorm() - static_cast<double>(left.size());
  std::vector<std::string> expressions;
  if (!(best.chi2_drop > kMost * excess)) return expressions;
  const std::string name = model::free_name(terms, "T_late_ripple");
  for (const double range : kLagRanges) {
    expressions.push_back(
        format("%s = sin(6.2832*(lag(T,?tau[%.4g,%.4g])/?p[%.4g,%.4g]+?c[-0.6,0.6]))", name.c_str(),
               best.lag_s / range, best.lag_s * range, best.period_degc / kPeriodRange,
               best.period_degc * kPeriodRange));
  }
  return expressions;
}

}  // namespace fogcomp::diagnosis
