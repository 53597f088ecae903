#include "identification/coefficient_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "identification/outlier_rows.hpp"
#include "identification/whitening.hpp"
#include "support/units.hpp"

namespace fogcomp {
namespace {

constexpr Eigen::Index kModes = 96;  // of each recording; what is faster counts as white
constexpr Eigen::Index kAllModes = 192;
constexpr Eigen::Index kMinModes = 16;
// Slow noise over white, in the first mode of the longest recording: from next to none up.
constexpr double kLeastRatio = 0.25;
constexpr double kRatioStep = 4;
constexpr int kLevels = 10;

// Slowly varying cosines over each recording, orthonormal, and the variance that slow noise has
// along them: that of the quiet parts, relative to white noise; flicker and a random walk, relative
// to the first mode of the longest recording.
struct SlowModes {
  Eigen::MatrixXd cosines;  // rows x modes
  Eigen::ArrayXd quiet;
  Eigen::ArrayXd flicker;
  Eigen::ArrayXd walk;
};

SlowModes slow_modes(const Rows& rows, const NoiseModel& noise) {
  const std::vector<RowRange> runs = rows.runs();
  const auto count = static_cast<Eigen::Index>(runs.size());
  const Eigen::Index most = std::clamp(kAllModes / count, kMinModes, kModes);
  std::size_t longest = 0;
  for (const RowRange& run : runs) longest = std::max(longest, run.size());
  std::vector<double> quiet;
  std::vector<double> flicker;
  std::vector<double> walk;
  std::vector<Eigen::MatrixXd> parts;
  for (const RowRange& run : runs) {
    const auto size = static_cast<Eigen::Index>(run.size());
    const Eigen::Index modes = std::min(most, std::max<Eigen::Index>(1, size / 4));
    const double relative = static_cast<double>(run.size()) / static_cast<double>(longest);
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(rows.size(), modes);
    for (Eigen::Index k = 0; k < modes; ++k) {
      const double angle = kPi * static_cast<double>(k) / static_cast<double>(size);
      const double norm = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(size));
      for (Eigen::Index i = 0; i < size; ++i) {
        part(static_cast<Eigen::Index>(run.first) + i, k) =
            norm * std::cos(angle * (static_cast<double>(i) + 0.5));
      }
      // The mean of a recording: a walk from 0 has pi^2/3 of the first mode. Of flicker what is
      // slower than the recording is its bias; what else moves the mean is about a third.
      const auto mode = static_cast<double>(k);
      quiet.push_back(noise.slow_density(k == 0 ? kPi / static_cast<double>(size) : angle));
      flicker.push_back(relative * (k == 0 ? 1.0 / 3 : 1 / mode));
      walk.push_back(relative * relative * (k == 0 ? kPi * kPi / 3 : 1 / (mode * mode)));
    }
    parts.push_back(std::move(part));
  }
  SlowModes all{side_by_side(parts, rows.size()), {}, {}, {}};
  all.quiet = Eigen::Map<const Eigen::ArrayXd>(quiet.data(), all.cosines.cols());
  all.flicker = Eigen::Map<const Eigen::ArrayXd>(flicker.data(), all.cosines.cols());
  all.walk = Eigen::Map<const Eigen::ArrayXd>(walk.data(), all.cosines.cols());
  return all;
}

// What the residual shows: squares along the modes and beside them, and what each kind of noise of
// level 1 would make of the former.
struct Shown {
  Eigen::ArrayXd squares;
  double fast_square = 0;
  double fast_rows = 0;
  Eigen::ArrayXd white;
  Eigen::ArrayXd quiet;
  Eigen::ArrayXd flicker;
  Eigen::ArrayXd walk;
};

struct Level {
  double quiet = 0;    // of the slow noise of the quiet parts
  double flicker = 0;  // over white, along the first mode
  double walk = 0;
  double white = 0;            // variance of a full row
  double log_probability = 0;  // but for a constant
};

// The white level that suits best, and how likely that is.
Level judge(const Shown& shown, double quiet, double flicker, double walk) {
  const Eigen::ArrayXd expected =
      shown.white + quiet * shown.quiet + flicker * shown.flicker + walk * shown.walk;
  const double squares = (shown.squares / expected).sum() + shown.fast_square;
  const double count = static_cast<double>(shown.squares.size()) + shown.fast_rows;
  const double white = squares / count;
  return {quiet, flicker, walk, white, -(expected.log().sum() + count * std::log(white)) / 2};
}

// Beforehand every fourth gyro has flicker or a random walk beside what its quiet parts show.
std::vector<Level> levels_of(const Shown& shown) {
  std::vector<double> ratios{0};
  for (int i = 0; i < kLevels; ++i) ratios.push_back(kLeastRatio * std::pow(kRatioStep, i));
  const double one_of_levels = -std::log(static_cast<double>(kLevels));
  std::vector<Level> levels;
  for (const double quiet : {0.0, 0.5, 1.0, 2.0}) {
    for (const double flicker : ratios) {
      for (const double walk : ratios) {
        levels.push_back(judge(shown, quiet, flicker, walk));
        if (flicker > 0) levels.back().log_probability += one_of_levels - std::log(3.0);
        if (walk > 0) levels.back().log_probability += one_of_levels - std::log(3.0);
      }
    }
  }
  return levels;
}

}  // namespace

Eigen::MatrixXd coefficient_covariance(const Rows& rows, const NoiseWeightedFit& fit) {
  if (fit.covariance.size() == 0) return {};
  // Coefficients are estimator' * rows.
  const Whitening whitening(fit.noise, rows, fit.row_weights);
  const Eigen::MatrixXd estimator = whitening.apply_transposed(fit.whitened * fit.covariance);
  const SlowModes modes = slow_modes(rows, fit.noise);
  const Eigen::MatrixXd of_modes = estimator.transpose() * modes.cosines;

  const Eigen::ArrayXd counted = (fit.row_weights.array() > 0).cast<double>();
  const Eigen::ArrayXd row_variance =
      (fit.row_weights.array() > 0).select(fit.row_weights.array().max(1e-300).inverse(), 0.0);
  const Eigen::VectorXd residual = bridged(rows, fit.residual_dph, counted.matrix());
  const Eigen::MatrixXd left =
      Eigen::MatrixXd::Identity(modes.cosines.cols(), modes.cosines.cols()) -
      (modes.cosines.transpose() * fit.columns) * of_modes.topRows(fit.columns.cols());
  const Eigen::MatrixXd share = left.cwiseAbs2();
  const double mean_variance = row_variance.sum() / std::max(1.0, counted.sum());

  Shown shown;
  shown.squares = (modes.cosines.transpose() * residual).array().square();
  shown.fast_rows = counted.sum() - static_cast<double>(modes.cosines.cols());
  shown.fast_square =
      ((residual.array().square() * counted).sum() - shown.squares.sum()) / mean_variance;
  shown.white = mean_variance * share.rowwise().sum().array() + 1e-3 * mean_variance;
  shown.quiet = mean_variance * (share * modes.quiet.matrix()).array();
  shown.flicker = mean_variance * (share * modes.flicker.matrix()).array();
  shown.walk = mean_variance * (share * modes.walk.matrix()).array();

  const std::vector<Level> levels = levels_of(shown);
  double best = -HUGE_VAL;
  for (const Level& level : levels) best = std::max(best, level.log_probability);
  double sum = 0;
  double white = 0;
  Eigen::ArrayXd slow = Eigen::ArrayXd::Zero(modes.flicker.size());
  for (const Level& level : levels) {
    const double probability = std::exp(level.log_probability - best);
    sum += probability;
    white += probability * level.white;
    slow += probability * level.white * mean_variance *
            (level.quiet * modes.quiet + level.flicker * modes.flicker + level.walk * modes.walk);
  }
  const Eigen::MatrixXd by_rows =
      estimator.transpose() * row_variance.matrix().asDiagonal() * estimator;
  return (white * by_rows + of_modes * slow.matrix().asDiagonal() * of_modes.transpose()) / sum;
}

}  // namespace fogcomp
