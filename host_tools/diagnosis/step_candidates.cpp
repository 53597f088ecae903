#include "diagnosis/step_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr int kStepsPerRun = 48;

// `step` at this row.
std::optional<Candidate::Shape> step_shape(const series::Rows& rows,
                                           const ProjectOutModel& project_out_model,
                                           model::EffectTerm step, std::size_t row) {
  VisiblePart part = project_out_model(fit::step_column(rows, row));
  if (part.visible[0] < rules::kMinVisible) return std::nullopt;
  step.parameters[0] = rows.time_s[row];
  step.identified[0] = false;
  return Candidate::Shape{std::move(step), part.columns.colwise().normalized(), row};
}

}  // namespace

std::vector<Candidate::Shape> step_shapes(const series::Rows& rows,
                                          const ProjectOutModel& project_out_model,
                                          const model::EffectTerm& step) {
  std::vector<Candidate::Shape> shapes;
  for (const recording::RowRange& run : rows.runs()) {
    for (int i = 1; i < kStepsPerRun; ++i) {
      const std::size_t at = run.first + run.size() * static_cast<std::size_t>(i) / kStepsPerRun;
      if (at <= run.first || at >= run.end) continue;
      auto shape = step_shape(rows, project_out_model, step, at);
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

// Rows at which steps explain most, best first. `drops`: approximate fall of chi^2 per row.
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
    const bool is_new = std::all_of(best.begin(), best.end(), [&](std::size_t other) {
      return are_apart(rows, row, other);
    });
    if (is_new) best.push_back(row);
  }
  return best;
}

}  // namespace

void place_steps(std::vector<Candidate::Shape>& shapes, const series::Rows& rows,
                 const Residualizer& residualizer, const Eigen::MatrixXd& smooth) {
  const Eigen::VectorXd left = projected_out(smooth, residualizer.residual());
  const noise::StepProducts steps = residualizer.whitening().steps(rows, left.head(rows.size()));
  const Eigen::VectorXd drops =
      steps.with.col(0).array().square() / steps.square.array().max(1e-300);
  // What smooth functions leave of a large effect is rougher than noise.
  const double roughness = std::max(1.0, left.squaredNorm() / static_cast<double>(rows.size()));
  const model::EffectTerm any = shapes.front().term;
  for (const std::size_t row : best_rows(rows, drops)) {
    auto placed = step_shape(rows, residualizer, any, row);
    if (!placed) continue;
    const Eigen::VectorXd sharp = projected_out(smooth, placed->basis);
    const double drop = std::pow(sharp.dot(left), 2) / std::max(sharp.squaredNorm(), 1e-300);
    if (drop < rules::kMinPlacedChi2Drop * roughness) break;
    const auto nearest = std::min_element(
        shapes.begin(), shapes.end(), [&](const Candidate::Shape& a, const Candidate::Shape& b) {
          const auto away = [&](const Candidate::Shape& shape) {
            const bool other_run = rows.run_at(shape.row) != rows.run_at(row);
            return std::pair(other_run, std::max(shape.row, row) - std::min(shape.row, row));
          };
          return away(a) < away(b);
        });
    *nearest = std::move(*placed);
  }
}

}  // namespace fogcomp::diagnosis
