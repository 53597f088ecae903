#include "identification/noise_model.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "support/median.hpp"

namespace fogcomp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLadderStep = 4;  // between neighbouring time constants
constexpr int kUpdates = 300;
constexpr double kNegligible = 1e-3;  // of the white variance: such a component is dropped

struct Spectrum {
  std::vector<double> angle;  // per row, 0..pi
  std::vector<double> power;  // expected value: sum of variance * density
};

void remove_line(Eigen::VectorXd& values) {
  const auto count = static_cast<double>(values.size());
  const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(values.size(), -1, 1);
  const double slope = t.dot(values) / t.squaredNorm();
  values.array() -= values.sum() / count;
  values -= slope * t;
}

// Outliers are no part of the noise that the rows are weighted with; a row of 60 sigma would be all
// of it.
void clip_outliers(Eigen::VectorXd& values) {
  constexpr double kMostSigma = 4;
  const double most = kMostSigma * sigma_by_median({values.begin(), values.end()});
  values = values.cwiseMax(-most).cwiseMin(most);
}

// Periodogram without its lowest two frequencies, which a removed line distorts.
void add_periodogram(Eigen::VectorXd values, Spectrum& spectrum) {
  remove_line(values);
  clip_outliers(values);
  Eigen::FFT<double> fft;
  std::vector<double> time(values.begin(), values.end());
  std::vector<std::complex<double>> frequency;
  fft.fwd(frequency, time);
  constexpr std::size_t kFirst = 3;
  for (std::size_t k = kFirst; 2 * k < time.size(); ++k) {
    spectrum.angle.push_back(2 * kPi * static_cast<double>(k) / static_cast<double>(time.size()));
    spectrum.power.push_back(std::norm(frequency[k]) / static_cast<double>(time.size()));
  }
}

// Spectral density of a sampled Gauss-Markov process of variance 1.
double density(double phi, double angle) {
  return (1 - phi * phi) / (1 - 2 * phi * std::cos(angle) + phi * phi);
}

}  // namespace

double NoiseModel::white_dph() const {
  return std::sqrt(white_variance);
}

double NoiseModel::wander_dph() const {
  double variance = 0;
  for (const Component& component : components) variance += component.variance;
  return std::sqrt(variance);
}

NoiseModel fit_noise(const std::vector<Eigen::VectorXd>& quiet, double row_s) {
  Spectrum spectrum;
  double longest_s = 0;
  for (const Eigen::VectorXd& stretch : quiet) {
    add_periodogram(stretch, spectrum);
    longest_s = std::max(longest_s, static_cast<double>(stretch.size()) * row_s);
  }
  NoiseModel noise;
  noise.row_s = row_s;
  noise.from_quiet_parts = true;
  for (double tau_s = 2 * row_s; tau_s <= longest_s / 2; tau_s *= kLadderStep) {
    noise.components.push_back({tau_s, 0});
  }

  const auto points = static_cast<Eigen::Index>(spectrum.power.size());
  const auto terms = static_cast<Eigen::Index>(noise.components.size()) + 1;
  Eigen::ArrayXXd basis(points, terms);
  for (Eigen::Index i = 0; i < points; ++i) {
    basis(i, 0) = 1;
    for (Eigen::Index j = 1; j < terms; ++j) {
      const double tau_s = noise.components[static_cast<std::size_t>(j - 1)].tau_s;
      basis(i, j) = density(std::exp(-row_s / tau_s), spectrum.angle[static_cast<std::size_t>(i)]);
    }
  }
  const Eigen::Map<const Eigen::ArrayXd> power(spectrum.power.data(), points);
  Eigen::ArrayXd variance =
      Eigen::ArrayXd::Constant(terms, power.mean() / static_cast<double>(terms));
  for (int update = 0; update < kUpdates; ++update) {
    const Eigen::ArrayXd model = (basis.matrix() * variance.matrix()).array();
    const Eigen::ArrayXd up =
        (basis.matrix().transpose() * (power / model.square()).matrix()).array();
    const Eigen::ArrayXd down = (basis.matrix().transpose() * model.inverse().matrix()).array();
    variance *= (up / down).sqrt();
  }
  noise.white_variance = variance[0];
  for (Eigen::Index j = 1; j < terms; ++j) {
    noise.components[static_cast<std::size_t>(j - 1)].variance = variance[j];
  }
  const double least = kNegligible * variance[0];
  noise.components.erase(
      std::remove_if(noise.components.begin(), noise.components.end(),
                     [&](const NoiseModel::Component& c) { return c.variance < least; }),
      noise.components.end());
  return noise;
}

NoiseModel white_noise_of(const Eigen::VectorXd& residual, double row_s) {
  NoiseModel noise;
  noise.row_s = row_s;
  std::vector<double> bends;
  for (Eigen::Index i = 2; i < residual.size(); ++i) {
    bends.push_back(residual[i] - 2 * residual[i - 1] + residual[i - 2]);
  }
  const double variance =
      bends.empty() ? residual.squaredNorm() : std::pow(sigma_by_median(std::move(bends)), 2) / 6;
  constexpr double kLeastVariance = 1e-30;  // rows without any noise can still be weighted
  noise.white_variance = std::max(variance, kLeastVariance);
  return noise;
}

}  // namespace fogcomp
