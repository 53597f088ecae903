#include "diagnosis/step_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "fit/predict.hpp"
#include "noise/gradual_change.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr int kStepsPerRun = 48;

// `step` at this row, in this row's recording only.
std::optional<Candidate::Shape> step_shape(const ShapeSpace& space, model::EffectTerm step,
                                           std::size_t row) {
  const series::Rows& rows = space.series.rows();
  const Eigen::MatrixXd column = fit::step_column(rows, row);
  VisiblePart part = space.project_out_model(column);
  if (part.visible[0] < rules::kMinVisible) return std::nullopt;
  step.parameters[0].value = rows.time_s[row];
  step.parameters[0].identified = false;
  step.recording = space.series.recording_of(row);
  return Candidate::Shape{std::move(step), part.columns.colwise().normalized().cast<float>(), row,
                          space.modes.of_effect(column)};
}

}  // namespace

std::vector<Candidate::Shape> step_shapes(const ShapeSpace& space, const model::EffectTerm& step) {
  const series::Rows& rows = space.series.rows();
  std::vector<Candidate::Shape> shapes;
  for (const recording::RowRange& run : rows.runs()) {
    for (int i = 1; i < kStepsPerRun; ++i) {
      const std::size_t at = run.first + run.size() * static_cast<std::size_t>(i) / kStepsPerRun;
      if (at <= run.first || at >= run.end) continue;
      auto shape = step_shape(space, step, at);
      if (shape) shapes.push_back(std::move(*shape));
    }
  }
  return shapes;
}

namespace {

// Whether two rows lie in different runs or at least half a grid interval apart.
bool are_apart(const series::Rows& rows, std::size_t a, std::size_t b) {
  const std::size_t run = rows.run_at(a);
  const std::size_t interval = rows.runs()[run].size() / kStepsPerRun;
  return rows.run_at(b) != run || std::max(a, b) - std::min(a, b) > interval / 2;
}

// Rows at which steps lower the square of a residual most, best first.
std::vector<std::size_t> best_rows(const series::Rows& rows, const Eigen::VectorXd& drops) {
  constexpr std::size_t kBestSteps = 4;
  std::vector<std::size_t> order(static_cast<std::size_t>(drops.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return drops[static_cast<Eigen::Index>(a)] > drops[static_cast<Eigen::Index>(b)];
  });
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < order.size() && best.size() < kBestSteps; ++i) {
    const std::size_t row = order[i];
    if (rows.runs()[rows.run_at(row)].first == row) continue;  // that is the run's bias
    const bool is_new = std::all_of(best.begin(), best.end(),
                                    [&](std::size_t other) { return are_apart(rows, row, other); });
    if (is_new) best.push_back(row);
  }
  return best;
}

// Steps of which each is moved at most once.
class Steps {
 public:
  Steps(std::vector<Candidate::Shape> shapes, const series::Rows& rows)
      : shapes_(std::move(shapes)), rows_(rows), moved_(shapes_.size(), false) {}

  /// Takes the place of the nearest step of the same run.
  void place(Candidate::Shape placed) {
    std::size_t nearest = shapes_.size();
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (moved_[i] && shapes_[i].row == placed.row) return;
      if (moved_[i] || rows_.run_at(shapes_[i].row) != rows_.run_at(placed.row)) continue;
      if (nearest == shapes_.size() || away(i, placed) < away(nearest, placed)) nearest = i;
    }
    if (nearest == shapes_.size()) return;
    shapes_[nearest] = std::move(placed);
    moved_[nearest] = true;
  }
  std::vector<Candidate::Shape> take() { return std::move(shapes_); }

 private:
  std::size_t away(std::size_t i, const Candidate::Shape& placed) const {
    return std::max(shapes_[i].row, placed.row) - std::min(shapes_[i].row, placed.row);
  }

  std::vector<Candidate::Shape> shapes_;
  const series::Rows& rows_;
  std::vector<bool> moved_;
};

}  // namespace

std::vector<Candidate::Shape> placed_steps(std::vector<Candidate::Shape> shapes,
                                           const ShapeSpace& space,
                                           const Residualizer& residualizer,
                                           const Eigen::MatrixXf& smooth_columns) {
  const series::Rows& rows = space.series.rows();
  const Eigen::MatrixXd smooth = smooth_columns.cast<double>();
  const Eigen::MatrixXd nothing(smooth.rows(), 0);
  Eigen::MatrixXd left(smooth.rows(), 2);
  left.col(0) = residualizer.residual();
  left.col(1) = projected_out(smooth, residualizer.residual());
  // What smooth functions leave of a large effect is rougher than noise.
  const double roughness =
      std::max(1.0, left.col(1).squaredNorm() / static_cast<double>(rows.size()));
  const Eigen::MatrixXd drops = residualizer.chi2_drops_of_steps(rows, left);
  const model::EffectTerm step = shapes.front().term;
  Steps steps(std::move(shapes), rows);
  const auto place = [&](Eigen::Index which, const Eigen::MatrixXd& beside, double min_drop) {
    for (const std::size_t row : best_rows(rows, drops.col(which))) {
      auto placed = step_shape(space, step, row);
      if (!placed) continue;
      const Eigen::VectorXd own = projected_out(beside, placed->basis.cast<double>());
      const double drop =
          std::pow(own.dot(left.col(which)), 2) / std::max(own.squaredNorm(), 1e-300);
      if (drop < min_drop) return;
      steps.place(std::move(*placed));
    }
  };
  place(0, nothing, rules::kMinMovedChi2Drop);
  place(1, smooth, rules::kMinPlacedChi2Drop * roughness);
  return steps.take();
}

std::vector<Candidate::Shape> without_gradual_steps(std::vector<Candidate::Shape> shapes,
                                                    const series::Rows& rows,
                                                    const fit::NoiseWeightedFit& fit) {
  const noise::Whitening whitening(fit::noise_beside(rows, fit), rows, fit.row_weights);
  const Eigen::VectorXd residual = whitening.apply(fit.residual_dph);
  std::vector<char> is_gradual(shapes.size());
  for_each_index(shapes.size(), [&](std::size_t i) {
    is_gradual[i] = noise::gain_of_gradual_change(shapes[i].row, whitening, rows, residual) >
                    kPossibleSigmas * kPossibleSigmas;
  });
  std::vector<Candidate::Shape> kept;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (is_gradual[i] == 0) kept.push_back(std::move(shapes[i]));
  }
  return kept;
}

}  // namespace fogcomp::diagnosis
