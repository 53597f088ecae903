#include "noise/allan_model.hpp"

#include <algorithm>
#include <cmath>

#include "support/units.hpp"

namespace fogcomp::noise {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kRandomTerms = AllanModel::kTerms - 1;  // all but the ramp
constexpr Index kFrequenciesPerOctave = 24;

// Two-sided spectral densities in Std 952's normalisation.
Eigen::RowVectorXd density_of_terms(double frequency_per_h, double period_h) {
  const double w = 2 * kPi * frequency_per_h;
  const double sine = std::sin(kPi * frequency_per_h * period_h);
  Eigen::RowVectorXd row(kRandomTerms);
  row << 4 / period_h * sine * sine, 1, 1 / w, 1 / (w * w);
  return row;
}

}  // namespace

Eigen::RowVectorXd AllanModel::variance_of_terms(double tau_h) {
  Eigen::RowVectorXd row(kTerms);
  row << 3 / (tau_h * tau_h), 1 / tau_h, 2 / kPi * std::log(2.0), tau_h / 3, tau_h * tau_h / 2;
  return row;
}

AllanModel::AllanModel(const std::vector<AllanPoint>& points) {
  const auto count = static_cast<Index>(points.size());
  for (VectorXd* vector : {&tau_h_, &span_h_, &range_h_, &ranges_}) vector->resize(count);
  terms_.resize(count, kTerms);
  for (Index k = 0; k < count; ++k) {
    const AllanPoint& point = points[static_cast<std::size_t>(k)];
    tau_h_[k] = point.tau_s / kSecondsPerHour;
    span_h_[k] = point.pairs * tau_h_[k];
    ranges_[k] = static_cast<double>(point.ranges);
    range_h_[k] = span_h_[k] / ranges_[k] + tau_h_[k];
    terms_.row(k) = variance_of_terms(tau_h_[k]);
  }

  // From the Nyquist frequency down to a sixteenth of that of the longest tau.
  const double period_h = tau_h_[0] / static_cast<double>(points[0].samples);
  const Index frequencies =
      kFrequenciesPerOctave * static_cast<Index>(std::log2(tau_h_[count - 1] / period_h) + 5);
  density_.resize(frequencies, kRandomTerms);
  response_.resize(frequencies, count);
  for (Index i = 0; i < frequencies; ++i) {
    const double octave = (static_cast<double>(i) + 0.5) / kFrequenciesPerOctave;
    const double frequency = 0.5 / period_h * std::exp2(-octave);
    const double bandwidth = frequency * std::log(2.0) / kFrequenciesPerOctave;
    density_.row(i) = density_of_terms(frequency, period_h);
    for (Index k = 0; k < count; ++k) {
      // Difference of two neighbouring means of m samples.
      const double m = tau_h_[k] / period_h;
      const double gain = std::pow(std::sin(kPi * frequency * tau_h_[k]), 2) /
                          (m * std::sin(kPi * frequency * period_h));
      response_(i, k) = 2 * gain * gain * std::sqrt(bandwidth);
    }
  }
}

MatrixXd AllanModel::covariance(const VectorXd& squares) const {
  MatrixXd result = covariance_of_noise(squares);
  if (squares[kRamp] > 0) result += covariance_of_ramp(squares);
  return result;
}

// For a Gaussian process, cov(mean x^2, mean y^2) = 2/T * integral of |cross density|^2 over all
// frequencies (Isserlis).
MatrixXd AllanModel::covariance_of_noise(const VectorXd& squares) const {
  const VectorXd density = density_ * squares.head(kRandomTerms);
  const MatrixXd spread = density.asDiagonal() * response_;
  const VectorXd per_span = span_h_.cwiseSqrt().cwiseInverse();
  return per_span.asDiagonal() * (4 * spread.transpose() * spread) * per_span.asDiagonal();
}

// Covariance from the product of ramp and noise. The mean of all differences of neighbouring
// averages is the difference between the averages at the two ends of a range, so their noise
// counts.
MatrixXd AllanModel::covariance_of_ramp(const VectorXd& squares) const {
  const Index count = tau_h_.size();
  MatrixXd result(count, count);
  for (Index j = 0; j < count; ++j) {
    for (Index k = 0; k < count; ++k) {
      const Index longer = std::max(j, k);
      const double tau_h = tau_h_[longer];
      const double range_h = range_h_[longer];
      const double variance_of_ends =
          2 * squares[kAngleWalk] / tau_h +
          2 / kPi * squares[kInstability] * (1 + std::log(range_h / tau_h)) +
          squares[kRateWalk] * range_h;
      const double shares = tau_h_[j] * tau_h_[k] / (range_h * range_h);
      result(j, k) =
          squares[kRamp] * tau_h_[j] * tau_h_[k] * shares * variance_of_ends / ranges_[longer];
    }
  }
  return result;
}

}  // namespace fogcomp::noise
