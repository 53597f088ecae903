#include "fit/walk_instead.hpp"

#include <algorithm>

#include "fit/noise_weighted_fit.hpp"
#include "fit/walk_rival.hpp"
#include "fit/whitened_problem.hpp"
#include "model/shape_parameter.hpp"

namespace fogcomp::fit {
namespace {

// What the change brings, about the new model: with the new coefficients of the old effects and, to
// first order, their shapes free, as they are beside a random walk. Else a walk would be credited
// with what the old effects alone can follow.
AddedColumns columns_of_change(const std::vector<model::EffectTerm>& before,
                               const std::vector<std::size_t>& changed,
                               const WhitenedProblem& problem, const KnownRegressors& known,
                               const noise::Whitening& whitening) {
  const auto is_changed = [&](std::size_t term) {
    return std::find(changed.begin(), changed.end(), term) != changed.end();
  };
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(problem.terms());
  const Eigen::MatrixXd all = problem.jacobian(shapes);
  std::vector<Eigen::MatrixXd> kept;
  std::vector<Eigen::MatrixXd> added;
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < problem.terms().size(); ++i) {
    const Eigen::Index count = known(problem.terms()[i])->cols();
    (is_changed(i) ? added : kept).emplace_back(all.middleCols(at, count));
    at += count;
  }
  const auto derivatives = static_cast<Eigen::Index>(shapes.size());
  const Eigen::Index nuisance = all.cols() - derivatives - at;
  kept.emplace_back(all.middleCols(at, nuisance));
  at += nuisance;
  for (const model::ShapeParameter& shape : shapes) {
    (is_changed(shape.term) ? added : kept).emplace_back(all.col(at++));
  }
  // of a changed effect: what it was
  for (const model::EffectTerm& term : before) kept.push_back(whitening.apply(*known(term)));
  return {side_by_side(kept, all.rows()), side_by_side(added, all.rows()), problem.measured()};
}

}  // namespace

double chance_of_walk_instead(const std::vector<model::EffectTerm>& before,
                              const std::vector<model::EffectTerm>& after,
                              const std::vector<std::size_t>& changed, const KnownRegressors& known,
                              const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const noise::Whitening whitening(with.noise, rows, with.row_weights);
  const WhitenedProblem problem(known, whitening, after,
                                run_offset_columns(rows, with.run_offsets));
  return chance_of_walk(rows, with.noise, whitening,
                        columns_of_change(before, changed, problem, known, whitening));
}

}  // namespace fogcomp::fit
