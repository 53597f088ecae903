#include "fit/walk_rival.hpp"

#include <algorithm>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "noise/random_walk.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

constexpr Eigen::Index kModesAtOnce = 16;  // whitened and projected: less memory than all of them

bool is_possible(const noise::NoiseModel::Walk& walk) {
  return walk.log_odds >= rules::kWalkRuledOut;
}

}  // namespace

Eigen::MatrixXf visible_walk_modes(const series::Rows& rows, const noise::NoiseModel& noise) {
  double max = 0;
  for (const noise::NoiseModel::Walk& walk : noise.walks) {
    if (is_possible(walk)) max = std::max(max, walk.coefficient);
  }
  return noise::random_walk_modes(rows, max / noise.white_dph());
}

WalkModes add_walk(ExplainedSpace& space, Eigen::MatrixXf& modes) {
  constexpr double kVisibleMode = 1e-9;
  const Eigen::VectorXd square = modes.cast<double>().colwise().squaredNorm();
  const double max = square.size() > 0 ? square.maxCoeff() : 0;
  WalkModes walk{{}, Eigen::VectorXd(modes.cols())};
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    if (square[i] <= kVisibleMode * max) continue;
    modes.col(count) = modes.col(i) / static_cast<float>(std::sqrt(square[i]));
    walk.square[count++] = square[i];
  }
  walk.square.conservativeResize(count);
  modes.conservativeResize(Eigen::NoChange, count);
  walk.columns = space.add(modes);
  return walk;
}

WalkRival find_walk(const ExplainedSpace& space, const WalkModes& modes,
                    const std::vector<noise::NoiseModel::Walk>& walks) {
  const auto variances = [&](double coefficient) -> Eigen::VectorXd {
    return std::pow(coefficient, 2) * modes.square;
  };
  std::vector<double> all;
  double best = 0;
  double max = 0;
  const double each = -std::log(std::max<double>(1, static_cast<double>(walks.size())));
  for (const noise::NoiseModel::Walk& walk : walks) {
    if (!is_possible(walk)) continue;
    all.push_back(each + walk.log_odds +
                  space.log_likelihood_of_noise(modes.columns, variances(walk.coefficient)));
    if (all.back() <= max) continue;
    max = all.back();
    best = walk.coefficient;
  }
  if (best == 0) return {0, 0, space};
  double sum = 0;
  for (const double log_odds : all) sum += std::exp(log_odds - max);
  return {best, max + std::log(sum), space.with_noise(modes.columns, variances(best))};
}

double chance_of_walk(const WalkRival& rival, const std::vector<Explanatory>& alone,
                      const std::vector<Explanatory>& beside) {
  double missing = 0;
  for (const Explanatory& one : alone) {
    missing += std::exp(one.log_evidence - rival.log_odds + one.log_prior);
  }
  for (const Explanatory& one : beside) missing += std::exp(one.log_evidence + one.log_prior);
  return 1 / (1 + missing);
}

namespace {

// Orthonormal directions of columns outside the span of `basis`. What a model must leave of a
// column is a part of its variation about `bias`: a supply of 5.0 to 5.1 V hardly differs from one.
Eigen::MatrixXd new_directions(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& basis,
                               const Eigen::MatrixXd& bias) {
  constexpr double kRounding = 1e-6;
  const Eigen::MatrixXd left = projected_out(basis, columns);
  const Eigen::MatrixXd variation = projected_out(bias, columns);
  std::vector<Eigen::MatrixXd> seen;
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    const double size = left.col(i).norm();
    if (size > rules::kMinSeen * variation.col(i).norm() &&
        size > kRounding * columns.col(i).norm())
      seen.emplace_back(left.col(i));
  }
  return orthonormal(side_by_side(seen, left.rows()));
}

}  // namespace

// Beside the effect the walk's coefficient is estimated anew: with the effect taken for a walk it
// would be too large, and the effect would seem to be nothing beside it.
double chance_of_walk(const series::Rows& rows, const noise::NoiseModel& noise,
                      const noise::Whitening& whitening, const AddedColumns& columns) {
  const Eigen::MatrixXd before = orthonormal(columns.before);
  const Eigen::MatrixXd bias =
      orthonormal(whitening.apply(Eigen::MatrixXd::Ones(columns.measured.size(), 1)));
  const Eigen::MatrixXd effect = new_directions(columns.added, before, bias);
  Eigen::MatrixXf modes = visible_walk_modes(rows, noise);
  for (Eigen::Index first = 0; first < modes.cols(); first += kModesAtOnce) {
    auto some = modes.middleCols(first, std::min(kModesAtOnce, modes.cols() - first));
    some = projected_out(before, whitening.apply(some.cast<double>())).cast<float>();
  }
  ExplainedSpace space(projected_out(before, columns.measured));
  const WalkModes walk = add_walk(space, modes);
  const Eigen::MatrixXf effect_columns = effect.cast<float>();
  const series::ColumnRange in_effect = space.add(effect_columns);
  space.finish();
  const double chi2_drop = (effect.transpose() * columns.measured).squaredNorm();
  const double evidence = log_evidence(chi2_drop, static_cast<double>(effect.cols()));
  const double beside = find_walk(space.without(in_effect), walk, noise.walks).log_odds;
  return chance_of_walk(find_walk(space, walk, noise.walks), {{evidence, 0}, {evidence, beside}},
                        {});
}

}  // namespace fogcomp::fit
