#include "fit/shape_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/descent.hpp"
#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "model/catalogue.hpp"
#include "support/parallel.hpp"

namespace fogcomp::fit {
namespace {

constexpr int kGridPoints = 24;
// From 2 to 60 degC, with half a turn over 100 degC between neighbours: a cosine that is half a
// turn off at the end of the data explains nothing.
constexpr int kPeriodGridPoints = 96;
constexpr std::size_t kMaxStarts = 3;  // per parameter
// Smallest relative decrease of the cost that justifies another step: when comparing starts, and at
// the end.
constexpr double kRoughly = 1e-5;
constexpr double kConverged = 1e-9;

int grid_points(const model::ShapeParameter& parameter) {
  return parameter.scale == fog::Scale::frequency ? kPeriodGridPoints : kGridPoints;
}

// The cost over the range of one parameter, the others following to first order.
struct Grid {
  std::vector<double> values;
  std::vector<double> costs;
};
Grid grid_of(const WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
             std::size_t which, const std::function<void(double)>& progress = {}) {
  const model::ShapeParameter& parameter = parameters[which];
  std::vector<model::ShapeParameter> others = parameters;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
  const int points = grid_points(parameter);
  Grid grid;
  for (int i = 0; i < points; ++i) grid.values.push_back(parameter.from_unit((i + 0.5) / points));
  grid.costs = problem.costs(parameter, grid.values, others, progress);
  return grid;
}

// Promising values of one parameter, best first: the deepest local minima of the cost over its
// grid, except the present one.
std::vector<double> starts_of(const WhitenedProblem& problem,
                              const std::vector<model::ShapeParameter>& parameters,
                              std::size_t which, const std::function<void(double)>& progress) {
  const model::ShapeParameter& parameter = parameters[which];
  const Grid grid = grid_of(problem, parameters, which, progress);
  const std::vector<double>& costs = grid.costs;
  const auto points = static_cast<double>(costs.size());
  const double here = parameter.to_unit(problem.value(parameter)) * points - 0.5;
  std::vector<std::size_t> dips;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool lower =
        (i == 0 || costs[i] < costs[i - 1]) && (i + 1 == costs.size() || costs[i] <= costs[i + 1]);
    if (lower && std::abs(static_cast<double>(i) - here) > 1) dips.push_back(i);
  }
  const std::size_t count = std::min(kMaxStarts, dips.size());
  std::partial_sort(dips.begin(), dips.begin() + static_cast<std::ptrdiff_t>(count), dips.end(),
                    [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  std::vector<double> starts;
  for (std::size_t i = 0; i < count; ++i) starts.push_back(grid.values[dips[i]]);
  return starts;
}

// Searches one parameter over its whole range and optimises all parameters from each promising
// value, side by side, so that what stays behind is abandoned early. Returns whether it moved to
// another local minimum.
bool search_range(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
                  std::size_t which, const std::function<void(double)>& progress) {
  std::vector<Descent> descents = {
      Descent(problem, parameters, kRoughly)};  // from here, then from elsewhere
  const auto grid_progress = [&](double done) { progress(done / 2); };
  for (const double value : starts_of(problem, parameters, which, grid_progress)) {
    problem.set({parameters[which]}, {value});
    descents.emplace_back(problem, parameters, kRoughly);
  }
  double best = 0;
  int rounds = 0;  // how many there will be, nobody knows
  for (bool going = true; going;) {
    progress(1 - 0.5 / ++rounds);
    for_each_index(descents.size(), [&](std::size_t i) {
      if (!descents[i].ended()) descents[i].step();
    });
    best = descents[0].cost();
    for (const Descent& descent : descents) best = std::min(best, descent.cost());
    going = false;
    for (Descent& descent : descents) {
      descent.abandon_if_above(best);
      going = going || !descent.ended();
    }
  }
  const auto lowest =
      std::min_element(descents.begin(), descents.end(),
                       [](const Descent& a, const Descent& b) { return a.cost() < b.cost(); });
  problem = std::move(lowest->problem());
  return lowest->cost() < descents[0].cost() * (1 - kRoughly);
}

// The two parts of an effect with an optional second part (radii, periods) are interchangeable: the
// smaller is made the first. Only if both were searched in the same range, so that the order cannot
// violate a bound.
bool is_second_part(const model::EffectTerm& term, std::size_t parameter) {
  return !term.expression &&
         model::is_optional_part(model::find_effect(term.name).parameters[parameter]);
}
void order_parts(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters) {
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const model::ShapeParameter& first = parameters[i - 1];
    const model::ShapeParameter& second = parameters[i];
    if (first.term != second.term || !is_second_part(problem.terms()[second.term], second.index) ||
        first.min != second.min || first.max != second.max) {
      continue;
    }
    const double smaller = std::min(problem.value(first), problem.value(second));
    const double larger = std::max(problem.value(first), problem.value(second));
    problem.set({first, second}, {smaller, larger});
  }
}

}  // namespace

std::vector<bool> search_shapes(WhitenedProblem& problem,
                                const std::vector<model::ShapeParameter>& parameters,
                                const std::vector<bool>& ranges, bool exact,
                                const std::function<void(double)>& progress) {
  std::vector<bool> elsewhere(parameters.size(), false);
  if (parameters.empty()) return elsewhere;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto part_done = [&](double part) {
      if (progress)
        progress((static_cast<double>(i) + part) / static_cast<double>(parameters.size()));
    };
    if (ranges[i]) elsewhere[i] = search_range(problem, parameters, i, part_done);
    part_done(1);
  }
  Descent last(problem, parameters, exact ? kConverged : kRoughly);
  last.finish();
  problem = std::move(last.problem());
  order_parts(problem, parameters);
  return elsewhere;
}

double first_order_cost(const WhitenedProblem& problem,
                        const std::vector<model::ShapeParameter>& parameters,
                        const std::vector<bool>& ranges) {
  if (parameters.empty()) {
    return solve_linear(problem.matrix(), problem.measured()).residual.squaredNorm();
  }
  double cost = problem.step(parameters, problem.solution()).cost;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!ranges[i]) continue;
    const std::vector<double> costs = grid_of(problem, parameters, i).costs;
    cost = std::min(cost, *std::min_element(costs.begin(), costs.end()));
  }
  return cost;
}

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
