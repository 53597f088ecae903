#include "fit/possible_gain.hpp"

#include <algorithm>

#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/shape_search.hpp"
#include "model/catalogue.hpp"

namespace fogcomp::fit {
namespace {

// Steps stay where they are.
std::vector<model::EffectTerm> with_fixed_events(std::vector<model::EffectTerm> terms) {
  for (model::EffectTerm& term : terms) {
    if (model::is_event(term)) std::fill(term.identified.begin(), term.identified.end(), false);
  }
  return terms;
}

}  // namespace

double possible_gain(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                     const std::vector<model::EffectTerm>& after, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const noise::Whitening whitening(with.noise, rows, with.row_weights);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, with.run_offsets);
  const auto cost_of = [&](const std::vector<model::EffectTerm>& terms) {
    const WhitenedProblem problem(known, whitening, with_fixed_events(terms), offsets);
    const std::vector<model::ShapeParameter> shapes = model::shape_parameters(problem.terms());
    std::vector<bool> is_left_out;  // before: then nothing is known of its place
    for (const model::ShapeParameter& shape : shapes) {
      is_left_out.push_back(model::is_left_at_zero(before[shape.term], shape.index));
    }
    return first_order_cost(problem, shapes, is_left_out);
  };
  return cost_of(before) - cost_of(after);
}

}  // namespace fogcomp::fit
