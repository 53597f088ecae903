#include "diagnosis/step_candidates.hpp"

#include <algorithm>
#include <optional>

#include "diagnosis/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"

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

void move_steps(const series::Rows& rows, const ProjectOutModel& project_out_model,
                std::vector<Candidate::Shape>& shapes, const Eigen::VectorXd& residual) {
  constexpr std::size_t kBestSteps = 4;
  const auto more = [&](const Candidate::Shape& a, const Candidate::Shape& b) {
    return a.chi2_drop(residual) > b.chi2_drop(residual);
  };
  const std::size_t count = std::min(kBestSteps, shapes.size());
  std::partial_sort(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(count),
                    shapes.end(), more);
  const std::vector<recording::RowRange> runs = rows.runs();
  for (std::size_t i = 0; i < count; ++i) {
    Candidate::Shape& shape = shapes[i];
    const recording::RowRange run =
        *std::find_if(runs.begin(), runs.end(),
                      [&](const recording::RowRange& one) { return shape.row < one.end; });
    for (std::size_t away = run.size() / kStepsPerRun / 2; away > 0; away /= 2) {
      for (const std::size_t row : {shape.row - away, shape.row + away}) {
        if (row <= run.first || row >= run.end) continue;
        auto tried = step_shape(rows, project_out_model, shape.term, row);
        if (!tried || !more(*tried, shape)) continue;
        shape = std::move(*tried);
        break;
      }
    }
  }
}

}  // namespace fogcomp::diagnosis
