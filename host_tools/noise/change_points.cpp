#include "noise/change_points.hpp"

#include <algorithm>
#include <cmath>

#include "noise/decision_rules.hpp"
#include "support/least_squares.hpp"
#include "support/units.hpp"

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

}  // namespace

std::optional<ChangePoint> find_change_point(const Whitening& whitening, const series::Rows& rows,
                                             const Eigen::VectorXd& whitened_residual,
                                             const Eigen::MatrixXd& whitened_columns) {
  const Steps steps = steps_of(whitening, rows, whitened_residual, whitened_columns);
  ChangePoint found;
  found.chi_square = steps.chi_square.maxCoeff(&found.row);
  if (!(found.chi_square > 0)) return std::nullopt;
  found.size_dph = steps.projection[found.row] / steps.square[found.row];
  found.size_sigma_dph = 1 / std::sqrt(steps.square[found.row]);
  found.chi_square_left =
      (steps.residual.squaredNorm() - found.chi_square) / steps.degrees_of_freedom;
  set_position(rows, steps.chi_square, found);
  return found;
}

Eigen::MatrixXd slow_columns(const series::Rows& rows, double half_period_s) {
  Eigen::MatrixXd columns(rows.size(), 0);
  for (const Run& run : runs_of(rows)) {
    const double start_s = rows.time_s[static_cast<std::size_t>(run.first)];
    const double length_s = rows.time_s[static_cast<std::size_t>(run.end - 1)] - start_s;
    const auto count = 1 + static_cast<Eigen::Index>(length_s / half_period_s);
    const Eigen::Index at = columns.cols();
    columns.conservativeResize(Eigen::NoChange, at + count);
    columns.rightCols(count).setZero();
    for (Eigen::Index k = 0; k < count; ++k) {
      for (Eigen::Index row = run.first; row < run.end; ++row) {
        const double turn = (rows.time_s[static_cast<std::size_t>(row)] - start_s) / length_s;
        columns(row, at + k) = std::cos(kPi * static_cast<double>(k) * turn);
      }
    }
  }
  return columns;
}

}  // namespace fogcomp::noise
