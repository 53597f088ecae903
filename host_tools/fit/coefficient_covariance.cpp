#include "fit/coefficient_covariance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fit/decision_rules.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/whitening.hpp"
#include "support/parallel.hpp"
#include "support/units.hpp"

namespace fogcomp::fit {
namespace {

constexpr Eigen::Index kMaxModes = 96;  // per recording; faster modes count as white
constexpr Eigen::Index kMaxAllModes = 192;
constexpr Eigen::Index kMinModes = 16;
// Grid of the ratio of slow to white noise in the first mode of the longest recording, from
// negligible up.
constexpr double kMinRatio = 0.25;
constexpr double kRatioStep = 4;
constexpr int kRatios = 10;

// Kinds of slow parts in a residual: slow noise of the quiet parts, additional flicker, a random
// walk, and the remainder of a missing effect. The latter follows the ramps, of which a programme
// has about ten to thirty: equal power in every mode up to there, less beyond.
enum Kind : Eigen::Index { kQuiet, kFlicker, kWalk, kLackingSlow, kLackingFast, kKinds };
using Amounts = Eigen::Matrix<double, kKinds, 1>;

// Orthonormal slow cosines over each recording, and the power of each kind in them: kQuiet relative
// to white noise, the others relative to the first mode of the longest recording.
struct SlowModes {
  Eigen::MatrixXd cosines;            // rows x modes
  Eigen::MatrixXd powers;             // modes x kinds
  double first_angle_of_longest = 0;  // per row
};

// Angles are whole multiples of that between two entries of the table: no cosine is computed twice.
void set_cosines(Eigen::Ref<Eigen::MatrixXd> cosines) {
  const Eigen::Index size = cosines.rows();
  const Eigen::Index turn = 4 * size;
  Eigen::VectorXd table(turn);
  for (Eigen::Index i = 0; i < turn; ++i) {
    table[i] = std::cos(2 * kPi * static_cast<double>(i) / static_cast<double>(turn));
  }
  for (Eigen::Index k = 0; k < cosines.cols(); ++k) {
    const double norm = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(size));
    Eigen::Index angle = k;
    for (Eigen::Index i = 0; i < size; ++i) {
      cosines(i, k) = norm * table[angle];
      angle += 2 * k;
      if (angle >= turn) angle -= turn;
    }
  }
}

// Powers of mode k of a recording whose length is `relative` of the longest one's. Mode 0 is the
// mean: a walk from 0 has pi^2/3 of the first mode there. Flicker slower than the recording is its
// bias; the remaining flicker of the mean is about a third.
Amounts powers_of_mode(Eigen::Index k, double first_angle, double relative,
                       const noise::NoiseModel& noise) {
  const auto mode = static_cast<double>(k);
  const auto beyond = [&](double corner) {
    return 1 / (1 + std::pow(mode / (relative * corner), 2));
  };
  Amounts powers;
  powers[kQuiet] = noise.slow_density(std::max(mode, 1.0) * first_angle);
  powers[kFlicker] = relative * (k == 0 ? 1.0 / 3 : 1 / mode);
  powers[kWalk] = relative * relative * (k == 0 ? kPi * kPi / 3 : 1 / (mode * mode));
  powers[kLackingSlow] = beyond(rules::kCornerSlow);
  powers[kLackingFast] = beyond(rules::kCornerFast);
  return powers;
}

SlowModes slow_modes(const series::Rows& rows, const noise::NoiseModel& noise) {
  const std::vector<recording::RowRange> runs = rows.runs();
  const Eigen::Index max =
      std::clamp(kMaxAllModes / static_cast<Eigen::Index>(runs.size()), kMinModes, kMaxModes);
  const auto modes_of = [&](const recording::RowRange& run) {
    return std::min(max, std::max<Eigen::Index>(1, static_cast<Eigen::Index>(run.size()) / 4));
  };
  std::size_t longest = 0;
  Eigen::Index count = 0;
  for (const recording::RowRange& run : runs) {
    longest = std::max(longest, run.size());
    count += modes_of(run);
  }
  SlowModes modes{Eigen::MatrixXd::Zero(rows.size(), count), Eigen::MatrixXd(count, kKinds),
                  kPi / static_cast<double>(longest)};
  Eigen::Index first = 0;
  for (const recording::RowRange& run : runs) {
    const auto size = static_cast<Eigen::Index>(run.size());
    set_cosines(
        modes.cosines.block(static_cast<Eigen::Index>(run.first), first, size, modes_of(run)));
    const double relative = static_cast<double>(run.size()) / static_cast<double>(longest);
    for (Eigen::Index k = 0; k < modes_of(run); ++k) {
      modes.powers.row(first + k) =
          powers_of_mode(k, kPi / static_cast<double>(size), relative, noise).transpose();
    }
    first += modes_of(run);
  }
  return modes;
}

// Statistics of the residual: squares within the modes and outside, and the expected squares within
// the modes for white noise and each kind of unit amount.
struct ResidualStatistics {
  Eigen::ArrayXd squares;
  double fast_square = 0;  // of the rows that count, without bridged ones
  double fast_rows = 0;
  Eigen::ArrayXd white;
  Eigen::MatrixXd slow;  // modes x kinds
};

ResidualStatistics shown_by(const series::Rows& rows, const NoiseWeightedFit& fit,
                            const SlowModes& modes, const Eigen::MatrixXd& of_modes,
                            double mean_variance) {
  const Eigen::ArrayXd counted = (fit.row_weights.array() > 0).cast<double>();
  const Eigen::VectorXd residual = noise::bridged(rows, fit.residual_dph, counted.matrix());
  // Response of the residual in all modes to a unit amplitude in each mode.
  const Eigen::MatrixXd left =
      Eigen::MatrixXd::Identity(modes.cosines.cols(), modes.cosines.cols()) -
      (modes.cosines.transpose() * fit.columns) * of_modes.topRows(fit.columns.cols());
  const Eigen::MatrixXd share = left.cwiseAbs2();
  ResidualStatistics statistics;
  const Eigen::VectorXd projection = modes.cosines.transpose() * residual;
  const Eigen::ArrayXd beside = (residual - modes.cosines * projection).array();
  statistics.squares = projection.array().square();
  statistics.fast_rows = counted.sum() - static_cast<double>(modes.cosines.cols());
  statistics.fast_square = (beside.square() * counted).sum() / mean_variance;
  statistics.white = mean_variance * share.rowwise().sum().array() + 1e-3 * mean_variance;
  statistics.slow = mean_variance * (share * modes.powers);
  return statistics;
}

// Amounts of all kinds and their probability.
struct Level {
  Amounts amounts = Amounts::Zero();
  double white = 0;            // variance of a full row
  double log_probability = 0;  // up to a constant
};

// Sum of the logarithms, each of a product of eight, because they take longer than all else here.
// Values are variances relative to a row's, far from the ends of a double's range.
double sum_of_logs(const Eigen::ArrayXd& values) {
  constexpr Eigen::Index kFactors = 8;
  double sum = 0;
  for (Eigen::Index i = 0; i < values.size(); i += kFactors) {
    sum += std::log(values.segment(i, std::min(kFactors, values.size() - i)).prod());
  }
  return sum;
}

// With the most probable white level.
void judge_by_residual(const ResidualStatistics& statistics, Level& level) {
  const Eigen::VectorXd slow = statistics.slow * level.amounts;
  const Eigen::ArrayXd expected = statistics.white + slow.array();
  const double squares = (statistics.squares / expected).sum() + statistics.fast_square;
  const double count = static_cast<double>(statistics.squares.size()) + statistics.fast_rows;
  level.white = std::max(squares / count, std::numeric_limits<double>::min());
  level.log_probability -= (sum_of_logs(expected) + count * std::log(level.white)) / 2;
}

// Densities of the noise kinds relative to white noise, in the spectrum of the quiet parts. A
// straight line was removed from each part, which leaves 6/5 of a walk's density.
Eigen::MatrixXd quiet_densities(const noise::NoiseModel& noise, double first_angle) {
  const Eigen::ArrayXd& angle = noise.quiet_spectrum.angle;
  Eigen::MatrixXd densities = Eigen::MatrixXd::Zero(angle.size(), kKinds);
  densities.col(kQuiet) = angle.unaryExpr([&](double one) { return noise.slow_density(one); });
  densities.col(kFlicker) = first_angle / angle;
  densities.col(kWalk) = 1.2 * first_angle * first_angle / (2 - 2 * angle.cos());
  return densities;
}

// Prior: every fourth gyro has flicker beyond its quiet parts, every fourth a random walk, and
// every fourth model lacks an effect.
std::vector<Level> levels_of(const ResidualStatistics& statistics, const noise::NoiseModel& noise,
                             double first_angle) {
  std::vector<double> ratios{0};
  for (int i = 0; i < kRatios; ++i) ratios.push_back(kMinRatio * std::pow(kRatioStep, i));
  const double any = -std::log(3.0 * kRatios);
  const Eigen::MatrixXd densities = quiet_densities(noise, first_angle);
  std::vector<Level> noises;
  for (const double quiet : {0.0, 0.5, 1.0, 2.0}) {
    for (const double flicker : ratios) {
      for (const double walk : ratios) {
        Level level;
        level.amounts << quiet, flicker, walk, 0, 0;
        noises.push_back(level);
      }
    }
  }
  constexpr std::size_t kOfEachNoise = 1 + 2 * kRatios;
  std::vector<Level> levels(kOfEachNoise * noises.size());
  for_each_index(noises.size(), [&](std::size_t i) {
    Level noise_alone = noises[i];
    const Amounts& amounts = noise_alone.amounts;
    noise_alone.log_probability =
        noise.quiet_spectrum.log_likelihood(1 + (densities * amounts).array()) +
        (amounts[kFlicker] > 0 ? any : 0) + (amounts[kWalk] > 0 ? any : 0);
    Level* level = &levels[kOfEachNoise * i];
    const auto add = [&](Kind lacking, double amount) {
      *level = noise_alone;
      level->amounts[lacking] = amount;
      if (amount > 0) level->log_probability += any - std::log(2.0);
      judge_by_residual(statistics, *level++);
    };
    add(kLackingSlow, 0);
    for (int ratio = 1; ratio <= kRatios; ++ratio) {
      for (const Kind lacking : {kLackingSlow, kLackingFast}) {
        add(lacking, ratios[static_cast<std::size_t>(ratio)]);
      }
    }
  });
  return levels;
}

// Half-width of the interval about 0 that contains 95 % of a mixture of normal distributions, over
// 1.96.
// The probability outside is convex in the half-width, so that Newton's steps from 0 do not pass
// it.
double mixture_sigma(const Eigen::ArrayXd& probabilities, const Eigen::ArrayXd& variances) {
  constexpr double kOutside = 0.05;
  constexpr double kNormal95 = 1.959964;
  constexpr int kMaxSteps = 100;
  constexpr double kExact = 1e-10;
  const double slope_of_erfc = 2 / std::sqrt(kPi);
  const Eigen::ArrayXd scale = (2 * variances.max(1e-300)).sqrt().inverse();
  double half_width = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    double outside = 0;
    double slope = 0;
    for (Eigen::Index i = 0; i < scale.size(); ++i) {
      const double relative = half_width * scale[i];
      outside += probabilities[i] * std::erfc(relative);
      slope += probabilities[i] * scale[i] * slope_of_erfc * std::exp(-relative * relative);
    }
    const double change = (outside - kOutside) / slope;
    half_width += change;
    if (!(change > kExact * half_width)) break;
  }
  return half_width / kNormal95;
}

// Levels of significant probability, most probable first; probabilities sum to 1.
struct LikelyLevels {
  std::vector<Level> levels;
  Eigen::ArrayXd probabilities;
};

LikelyLevels likely(std::vector<Level> levels) {
  constexpr double kNegligible = -14;  // ln of a millionth of the largest
  std::sort(levels.begin(), levels.end(),
            [](const Level& a, const Level& b) { return a.log_probability > b.log_probability; });
  const double best = levels.front().log_probability;
  const auto end = std::find_if(levels.begin(), levels.end(), [&](const Level& level) {
    return level.log_probability < best + kNegligible;
  });
  levels.erase(end, levels.end());
  Eigen::ArrayXd probabilities(levels.size());
  for (Eigen::Index i = 0; i < probabilities.size(); ++i) {
    probabilities[i] = std::exp(levels[static_cast<std::size_t>(i)].log_probability - best);
  }
  probabilities /= probabilities.sum();
  return {std::move(levels), std::move(probabilities)};
}

}  // namespace

Eigen::MatrixXd coefficient_covariance(const series::Rows& rows, const NoiseWeightedFit& fit) {
  if (fit.covariance.size() == 0) return {};
  // coefficients = estimator' * rows
  const noise::Whitening whitening(fit.noise, rows, fit.row_weights);
  const Eigen::MatrixXd estimator = whitening.apply_transposed(fit.whitened * fit.covariance);
  const SlowModes modes = slow_modes(rows, fit.noise);
  const Eigen::MatrixXd of_modes = estimator.transpose() * modes.cosines;
  const Eigen::ArrayXd row_variance =
      (fit.row_weights.array() > 0).select(fit.row_weights.array().max(1e-300).inverse(), 0.0);
  const double mean_variance =
      row_variance.sum() / std::max<double>(1, static_cast<double>((row_variance > 0).count()));
  const LikelyLevels likely_levels =
      likely(levels_of(shown_by(rows, fit, modes, of_modes, mean_variance), fit.noise,
                       modes.first_angle_of_longest));

  const Eigen::MatrixXd by_rows =
      estimator.transpose() * row_variance.matrix().asDiagonal() * estimator;
  const Eigen::MatrixXd squares = of_modes.cwiseAbs2();
  const Eigen::ArrayXd& probabilities = likely_levels.probabilities;
  Eigen::ArrayXXd variances(by_rows.rows(), probabilities.size());
  double white = 0;
  Eigen::VectorXd slow = Eigen::VectorXd::Zero(modes.powers.rows());
  for (Eigen::Index i = 0; i < probabilities.size(); ++i) {
    const Level& level = likely_levels.levels[static_cast<std::size_t>(i)];
    const Eigen::VectorXd projection = level.white * mean_variance * (modes.powers * level.amounts);
    variances.col(i) = level.white * by_rows.diagonal().array() + (squares * projection).array();
    white += probabilities[i] * level.white;
    slow += probabilities[i] * projection;
  }
  const Eigen::MatrixXd covariance =
      white * by_rows + of_modes * slow.asDiagonal() * of_modes.transpose();
  Eigen::VectorXd scale(covariance.rows());
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    scale[i] =
        mixture_sigma(probabilities, variances.row(i).transpose()) / std::sqrt(covariance(i, i));
  }
  return scale.asDiagonal() * covariance * scale.asDiagonal();
}

}  // namespace fogcomp::fit
