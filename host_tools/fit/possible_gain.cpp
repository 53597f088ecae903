#include "fit/possible_gain.hpp"

#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/shape_search.hpp"

namespace fogcomp::fit {

double possible_gain(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                     const std::vector<model::EffectTerm>& after, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const noise::Whitening whitening(with.noise, rows, with.row_weights);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, with.run_offsets);
  const auto cost_of = [&](const std::vector<model::EffectTerm>& terms) {
    const WhitenedProblem problem(known, whitening, terms, offsets);
    const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
    std::vector<bool> is_left_out;  // before: then nothing is known of its place
    for (const model::ShapeParameter& shape : shapes) {
      is_left_out.push_back(before[shape.term].parameters[shape.index].is_left_at_zero());
    }
    return first_order_cost(problem, shapes, is_left_out);
  };
  return cost_of(before) - cost_of(after);
}

}  // namespace fogcomp::fit
