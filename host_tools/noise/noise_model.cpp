#include "noise/noise_model.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "noise/decision_rules.hpp"
#include "noise/jumps.hpp"
#include "support/evidence.hpp"
#include "support/fourier.hpp"
#include "support/statistics.hpp"
#include "support/units.hpp"

namespace fogcomp::noise {
namespace {

constexpr double kLadderStep = 4;  // between neighbouring time constants
constexpr int kUpdates = 300;
constexpr double kMinVariance = 1e-30;  // so that rows without noise have finite weights
constexpr double kLateStart =
    1e-3;  // fraction of the mean power: single components grow where flicker is not enough

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

// Outliers must not determine the noise: a row of 60 sigma would dominate it.
void clip_outliers(Eigen::VectorXd& values) {
  const double max = kRareSigmas * sigma_by_median({values.begin(), values.end()});
  if (max == 0) return;  // most rows are rounded to one value: the others are no outliers
  values = values.cwiseMax(-max).cwiseMin(max);
}

void add_periodogram(const NoiseSample& sample, Spectrum& spectrum) {
  Eigen::VectorXd values = sample.values;
  remove_line(values);
  clip_outliers(values);
  const std::vector<double> powers = periodogram({values.begin(), values.end()});
  for (std::size_t k = sample.first_frequency; k < powers.size(); ++k) {
    spectrum.angle.push_back(2 * kPi * static_cast<double>(k) / static_cast<double>(values.size()));
    spectrum.power.push_back(powers[k]);
  }
}

// Spectral density of a sampled Gauss-Markov process of variance 1.
double density(double phi, double cosine_of_angle) {
  return (1 - phi * phi) / (1 - 2 * phi * cosine_of_angle + phi * phi);
}

// Expected power for unit variances: columns white, flicker, then one per Gauss-Markov component.
Eigen::ArrayXXd basis_of(const std::vector<double>& angles, double row_s,
                         const std::vector<double>& taus_s, std::size_t own) {
  const auto points = static_cast<Eigen::Index>(angles.size());
  Eigen::ArrayXXd basis = Eigen::ArrayXXd::Zero(points, 2 + static_cast<Eigen::Index>(own));
  basis.col(0) = 1;
  const Eigen::ArrayXd cosines = Eigen::Map<const Eigen::ArrayXd>(angles.data(), points).cos();
  for (std::size_t j = 0; j < taus_s.size(); ++j) {
    const double phi = std::exp(-row_s / taus_s[j]);
    for (Eigen::Index i = 0; i < points; ++i) {
      const double power = density(phi, cosines[i]);
      basis(i, 1) += power;
      if (j < own) basis(i, 2 + static_cast<Eigen::Index>(j)) = power;
    }
  }
  return basis;
}

// Degrees of freedom of the power at a low frequency, as of a variance of so many values: from the
// curvature of Whittle's likelihood in the levels of white noise and of the slow part. The slow
// part is taken as flicker, of which little may be visible, and as the fitted components, which may
// be mostly one and come from few periods; the less certain counts. With both levels unknown this
// would give the true scatter, some five times less; but then effects of 1.6 times the noise were
// missed.
double degrees_of_freedom_of(const Eigen::ArrayXXd& basis, const Eigen::ArrayXd& variance,
                             const Eigen::ArrayXd& low) {
  const Eigen::ArrayXd model = (basis.matrix() * variance.matrix()).array();
  const double power = (low * variance).sum();
  Eigen::ArrayXd flicker = Eigen::ArrayXd::Zero(variance.size());
  flicker[1] = 1;
  Eigen::ArrayXd found = variance;
  found[0] = 0;
  double degrees_of_freedom = rules::kMaxDegreesOfFreedom;
  for (const Eigen::ArrayXd& slow : {flicker, found}) {
    Eigen::MatrixX2d scaled(basis.rows(), 2);
    scaled.col(0) = (basis.col(0) / model).matrix();
    scaled.col(1) = ((basis.matrix() * slow.matrix()).array() / model).matrix();
    const Eigen::Matrix2d information = scaled.transpose() * scaled;
    const Eigen::Vector2d towards(low[0], (low * slow).sum());
    const double spread = towards.dot(information.inverse() * towards);
    const bool has_shape = spread > 0;  // the fitted components may all be 0
    if (has_shape) degrees_of_freedom = std::min(degrees_of_freedom, 2 * power * power / spread);
  }
  return std::max(degrees_of_freedom, rules::kMinFreedom);
}

// Bands a sixteenth of an octave wide.
QuietSpectrum in_bands(const Spectrum& spectrum, double white_variance) {
  constexpr double kBandsPerOctave = 16;
  std::map<int, std::array<double, 3>> bands;
  for (std::size_t i = 0; i < spectrum.angle.size(); ++i) {
    auto& [angle, power, count] =
        bands[static_cast<int>(std::floor(kBandsPerOctave * std::log2(spectrum.angle[i])))];
    angle += spectrum.angle[i];
    power += spectrum.power[i] / white_variance;
    ++count;
  }
  const auto size = static_cast<Eigen::Index>(bands.size());
  QuietSpectrum quiet{Eigen::ArrayXd(size), Eigen::ArrayXd(size), Eigen::ArrayXd(size)};
  Eigen::Index at = 0;
  for (const auto& [band, sums] : bands) {
    quiet.angle[at] = sums[0] / sums[2];
    quiet.power[at] = sums[1] / sums[2];
    quiet.count[at++] = sums[2];
  }
  return quiet;
}

// Coefficients of random walks that drift by 1/16 to 8 times the white noise of a row in a run.
std::vector<NoiseModel::Walk> possible_walks(double white_dph, double run_s) {
  std::vector<NoiseModel::Walk> walks;
  for (int half_octave = -8; half_octave <= 6; ++half_octave) {
    const double ratio = std::exp2(half_octave / 2.0);
    walks.push_back({ratio * white_dph / std::sqrt(run_s / kSecondsPerHour), 0});
  }
  return walks;
}

// Whittle's likelihood of each walk, with the fitted slow noise scaled as is most probable beside
// it, because that noise may be the walk.
void weigh_walks(const Spectrum& spectrum, const Eigen::ArrayXd& white, const Eigen::ArrayXd& slow,
                 double row_s, std::vector<NoiseModel::Walk>& walks) {
  const Eigen::Map<const Eigen::ArrayXd> power(spectrum.power.data(), white.size());
  const Eigen::Map<const Eigen::ArrayXd> angle(spectrum.angle.data(), white.size());
  const Eigen::ArrayXd walk = row_s / kSecondsPerHour / (2 - 2 * angle.cos());
  const auto log_likelihood = [&](double coefficient) {
    double best = -HUGE_VAL;
    for (const double share : {1.0, 0.5, 0.25, 0.0}) {
      const Eigen::ArrayXd model = white + share * slow + coefficient * coefficient * walk;
      best = std::max(best, -(model.log() + power / model).sum());
    }
    return best;
  };
  const double none = log_likelihood(0);
  for (NoiseModel::Walk& one : walks) one.log_odds = log_likelihood(one.coefficient) - none;
}

// Time constants of the possible components: for flicker all, as single components those that a
// sample can show.
struct TimeConstants {
  std::vector<double> all_s;
  std::size_t own = 0;
  double longest_s = 0;  // of the run for which the noise is needed
};

TimeConstants time_constants(const std::vector<NoiseSample>& samples, double row_s, double run_s) {
  double longest_s = 0;
  for (const NoiseSample& sample : samples) {
    const double periods = static_cast<double>(sample.first_frequency) / 3;
    longest_s = std::max(longest_s, static_cast<double>(sample.values.size()) * row_s / periods);
  }
  TimeConstants taus;
  taus.longest_s = std::max(run_s, longest_s);
  for (double tau_s = 2 * row_s; tau_s <= std::max(longest_s / 2, run_s); tau_s *= kLadderStep) {
    taus.all_s.push_back(tau_s);
    if (tau_s <= longest_s / 2) ++taus.own;
  }
  return taus;
}

// By multiplicative updates, which keep variances positive.
Eigen::ArrayXd likeliest_variances(const Eigen::ArrayXXd& basis, const Eigen::ArrayXd& power) {
  Eigen::ArrayXd variance = Eigen::ArrayXd::Constant(basis.cols(), kLateStart * power.mean());
  variance[0] = power.mean() / 2;
  variance[1] = power.mean() / (2 * basis.col(1).mean());
  for (int update = 0; update < kUpdates; ++update) {
    const Eigen::ArrayXd model = (basis.matrix() * variance.matrix()).array();
    const Eigen::ArrayXd up =
        (basis.matrix().transpose() * (power / model.square()).matrix()).array();
    const Eigen::ArrayXd down = (basis.matrix().transpose() * model.inverse().matrix()).array();
    variance *= (up / down).sqrt();
  }
  return variance;
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

double NoiseModel::slow_density(double angle) const {
  double sum = 0;
  for (const Component& component : components) {
    sum += component.variance * density(std::exp(-row_s / component.tau_s), std::cos(angle));
  }
  return sum / white_variance;
}

std::vector<NoiseSample> noise_samples(const std::vector<Eigen::VectorXd>& stretches) {
  std::vector<NoiseSample> samples;
  for (Eigen::VectorXd& part : split_at_jumps(stretches)) samples.push_back({std::move(part)});
  return samples;
}

NoiseModel fit_noise(const std::vector<NoiseSample>& samples, double row_s, double run_s) {
  Spectrum spectrum;
  for (const NoiseSample& sample : samples) add_periodogram(sample, spectrum);
  const TimeConstants taus = time_constants(samples, row_s, run_s);
  const Eigen::ArrayXXd basis = basis_of(spectrum.angle, row_s, taus.all_s, taus.own);
  const Eigen::Map<const Eigen::ArrayXd> power(spectrum.power.data(), basis.rows());
  NoiseModel noise;
  noise.row_s = row_s;
  noise.from_quiet_parts = true;
  noise.degrees_of_freedom = 1;
  noise.white_variance = kMinVariance;
  if (!(power.mean() > 0)) return noise;  // equal values in all rows
  const Eigen::ArrayXd variance = likeliest_variances(basis, power);
  noise.white_variance = variance[0];
  noise.quiet_spectrum = in_bands(spectrum, noise.white_variance);
  noise.walks = possible_walks(noise.white_dph(), taus.longest_s);
  Eigen::ArrayXd slow = variance;
  slow[0] = 0;
  weigh_walks(spectrum, basis.col(0) * variance[0], (basis.matrix() * slow.matrix()).array(), row_s,
              noise.walks);
  const Eigen::ArrayXXd lowest = basis_of(
      {2 * kPi * rules::kMinNoisePeriods * row_s / taus.longest_s}, row_s, taus.all_s, taus.own);
  noise.degrees_of_freedom = degrees_of_freedom_of(basis, variance, lowest.row(0));
  for (std::size_t j = 0; j < taus.all_s.size(); ++j) {
    const double alone = j < taus.own ? variance[2 + static_cast<Eigen::Index>(j)] : 0;
    const double all = variance[1] + alone;
    if (all >= rules::kNegligibleComponent * variance[0])
      noise.components.push_back({taus.all_s[j], all});
  }
  return noise;
}

NoiseModel white_noise_of(const Eigen::VectorXd& residual, double row_s, double run_s) {
  NoiseModel noise;
  noise.row_s = row_s;
  noise.degrees_of_freedom = 1;
  std::vector<double> bends;
  for (Eigen::Index i = 2; i < residual.size(); ++i) {
    bends.push_back(residual[i] - 2 * residual[i - 1] + residual[i - 2]);
  }
  const double variance =
      bends.empty() ? residual.squaredNorm() : std::pow(sigma_by_median(std::move(bends)), 2) / 6;
  noise.white_variance = std::max(variance, kMinVariance);
  noise.walks = possible_walks(noise.white_dph(), run_s);
  return noise;
}

}  // namespace fogcomp::noise
