#include "noise/change_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "noise/decision_rules.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::noise {
namespace {

// First row and end of each recording, as Eigen indices.
struct Run {
  Eigen::Index first;
  Eigen::Index end;
};
std::vector<Run> runs_of(const series::Rows& rows) {
  std::vector<Run> runs;
  for (const recording::RowRange& run : rows.runs()) {
    runs.push_back({static_cast<Eigen::Index>(run.first), static_cast<Eigen::Index>(run.end)});
  }
  return runs;
}

double time_before(const series::Rows& rows, Eigen::Index row) {
  const auto at = static_cast<std::size_t>(row);
  return (rows.time_s[at - 1] + rows.time_s[at]) / 2;
}

// Steps starting at each row, fitted beside the model.
struct Steps {
  Eigen::VectorXd residual;       // of the model
  Eigen::VectorXd projection;     // inner product of residual and step
  Eigen::VectorXd square;         // squared length of the step, model projected out
  Eigen::VectorXd chi_square;     // explained by the step; 0 if undetermined
  double degrees_of_freedom = 1;  // of the residual of the step
};

Steps steps_of(const Whitening& whitening, const series::Rows& rows,
               const Eigen::VectorXd& whitened_residual, const Eigen::MatrixXd& whitened_columns) {
  const Eigen::MatrixXd model = orthonormal(whitened_columns);
  Steps steps;
  steps.residual = whitened_residual - model * (model.transpose() * whitened_residual);
  Eigen::MatrixXd beside(rows.size(), model.cols() + 1);
  beside << model, steps.residual;
  const StepProducts products = whitening.steps(rows, beside);
  steps.square = products.square - products.with.leftCols(model.cols()).rowwise().squaredNorm();
  steps.projection = products.with.col(model.cols());
  steps.chi_square = Eigen::VectorXd::Zero(rows.size());
  for (const Run& run : runs_of(rows)) {
    for (Eigen::Index row = run.first + rules::kMinRowsBeside;
         row <= run.end - rules::kMinRowsBeside; ++row) {
      if (steps.square[row] <= rules::kUndeterminedStep * products.square[row]) continue;
      steps.chi_square[row] = steps.projection[row] * steps.projection[row] / steps.square[row];
    }
  }
  steps.degrees_of_freedom = std::max(1.0, static_cast<double>(rows.size() - model.cols() - 2));
  return steps;
}

// Sets the possible rows of a step and the uncertainty of its time. Each row around the best has
// the probability exp(chi^2 / 2) of a normal likelihood.
void set_position(const series::Rows& rows, const Eigen::VectorXd& chi_square, ChangePoint& found) {
  const double unit = std::max(1.0, found.chi_square_left);
  double total = 0;
  double mean_s = 0;
  double square_s = 0;
  const auto weigh = [&](Eigen::Index row) {
    const double below = (found.chi_square - chi_square[row]) / unit;
    if (chi_square[row] <= 0 || below > rules::kStepWithin) return false;
    const double probability = std::exp(-below / 2);
    const double away_s = time_before(rows, row) - time_before(rows, found.row);
    total += probability;
    mean_s += probability * away_s;
    square_s += probability * away_s * away_s;
    return true;
  };
  for (found.last = found.row; found.last < rows.size() && weigh(found.last);) ++found.last;
  for (found.first = found.row - 1; found.first > 0 && weigh(found.first);) --found.first;
  --found.last;
  found.time_s = time_before(rows, found.row);
  // Within a row the time is uniformly distributed.
  found.time_sigma_s =
      std::sqrt(square_s / total - std::pow(mean_s / total, 2) + rows.row_s * rows.row_s / 12);
}

recording::RowRange peak_around(Eigen::Index row, const Eigen::VectorXd& chi_square) {
  const auto belongs = [&](Eigen::Index other) { return chi_square[other] >= chi_square[row] / 2; };
  Eigen::Index first = row;
  Eigen::Index end = row + 1;
  while (first > 0 && belongs(first - 1)) --first;
  while (end < chi_square.size() && belongs(end)) ++end;
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(end)};
}

constexpr double kSlowestChangeS = 480;

// The rows of one recording around a jump.
struct Surroundings {
  Eigen::Index first = 0;
  Eigen::VectorXd away_s;  // since the jump
};

Surroundings surroundings_of(const series::Rows& rows, std::size_t jump) {
  const double jump_s = time_before(rows, static_cast<Eigen::Index>(jump));
  const recording::RowRange run = rows.runs()[rows.run_at(jump)];
  const auto is_near = [&](std::size_t row) {
    return std::abs(rows.time_s[row] - jump_s) <= kSlowestChangeS;
  };
  std::size_t first = jump - 1;
  std::size_t end = jump + 1;
  while (first > run.first && is_near(first - 1)) --first;
  while (end < run.end && is_near(end)) ++end;
  Surroundings near{static_cast<Eigen::Index>(first),
                    Eigen::VectorXd(static_cast<Eigen::Index>(end - first))};
  for (std::size_t row = first; row < end; ++row)
    near.away_s[static_cast<Eigen::Index>(row - first)] = rows.time_s[row] - jump_s;
  return near;
}

constexpr Eigen::Index kColumnsBeside = 5;

// Of those rows: a curve and the two rows next to the jump; the jump; and changes that take a time.
Eigen::MatrixXd changes_near(const Surroundings& near, Eigen::Index jump) {
  constexpr std::array<double, 4> kTakesS{60, 120, 240, kSlowestChangeS};
  constexpr std::array<double, 5> kPlaces{-0.5, -0.25, 0, 0.25, 0.5};
  const Eigen::ArrayXd away_s = near.away_s;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(
      away_s.size(),
      kColumnsBeside + 1 + static_cast<Eigen::Index>(kTakesS.size() * kPlaces.size()));
  for (int power = 0; power < 3; ++power)
    columns.col(power) = (away_s / kSlowestChangeS).pow(power);
  for (const Eigen::Index next : {jump - 1, jump}) columns(next - near.first, 4 + next - jump) = 1;
  columns.col(kColumnsBeside) = (away_s > 0).cast<double>();
  Eigen::Index column = kColumnsBeside;
  for (const double takes_s : kTakesS) {
    for (const double place : kPlaces)
      columns.col(++column) = (0.5 - place + away_s / takes_s).cwiseMax(0).cwiseMin(1);
  }
  return columns;
}

}  // namespace

std::optional<ChangePoint> find_change_point(const Whitening& whitening, const series::Rows& rows,
                                             const Eigen::VectorXd& whitened_residual,
                                             const Eigen::MatrixXd& whitened_columns,
                                             const std::vector<bool>& except) {
  Steps steps = steps_of(whitening, rows, whitened_residual, whitened_columns);
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    if (except[static_cast<std::size_t>(row)]) steps.chi_square[row] = 0;
  }
  ChangePoint found;
  found.chi_square = steps.chi_square.maxCoeff(&found.row);
  if (!(found.chi_square > 0)) return std::nullopt;
  found.size_dph = steps.projection[found.row] / steps.square[found.row];
  found.size_sigma_dph = 1 / std::sqrt(steps.square[found.row]);
  found.chi_square_left =
      (steps.residual.squaredNorm() - found.chi_square) / steps.degrees_of_freedom;
  set_position(rows, steps.chi_square, found);
  found.peak = peak_around(found.row, steps.chi_square);
  return found;
}

double gain_of_gradual_change(std::size_t row, const Whitening& whitening, const series::Rows& rows,
                              const Eigen::VectorXd& whitened_residual) {
  const Surroundings near = surroundings_of(rows, row);
  const Eigen::Index count = near.away_s.size();
  const Eigen::MatrixXd plain = changes_near(near, static_cast<Eigen::Index>(row));
  Eigen::MatrixXd of_all_rows = Eigen::MatrixXd::Zero(rows.size(), plain.cols());
  of_all_rows.middleRows(near.first, count) = plain;
  const Eigen::MatrixXd white = whitening.apply(of_all_rows).middleRows(near.first, count);
  const Eigen::MatrixXd beside = orthonormal(white.leftCols(kColumnsBeside));
  const auto left = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
    return columns - beside * (beside.transpose() * columns);
  };
  const Eigen::VectorXd residual = left(whitened_residual.segment(near.first, count));
  const Eigen::MatrixXd changes = left(white.rightCols(white.cols() - kColumnsBeside));
  const Eigen::ArrayXd squares = changes.colwise().squaredNorm().transpose().cwiseMax(1e-300);
  const Eigen::ArrayXd explained = (changes.transpose() * residual).array().square() / squares;
  const double most = explained.maxCoeff();
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, count - kColumnsBeside - 1));
  return (most - explained[0]) / std::max(1.0, (residual.squaredNorm() - most) / freedom);
}

}  // namespace fogcomp::noise
