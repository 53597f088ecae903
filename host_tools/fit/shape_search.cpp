#include "fit/shape_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/catalogue.hpp"
#include "support/parallel.hpp"

namespace fogcomp::fit {
namespace {

constexpr int kGridPoints = 24;
// From 2 to 60 degC, with half a turn over 100 degC between neighbours: a cosine that is half a
// turn off at the end of the data explains nothing.
constexpr int kPeriodGridPoints = 96;
constexpr std::size_t kMaxStarts = 3;  // per parameter
constexpr int kGaussNewtonSteps = 12;
// Smallest relative decrease of the cost that justifies another step: when comparing starts, and at
// the end.
constexpr double kRoughly = 1e-5;
constexpr double kConverged = 1e-9;

int grid_points(const model::ShapeParameter& parameter) {
  return parameter.scale == fog::Scale::frequency ? kPeriodGridPoints : kGridPoints;
}

// Promising values of one parameter, best first: the deepest local minima of the cost over its
// grid, except the present one.
std::vector<double> starts_of(const WhitenedProblem& problem,
                              const std::vector<model::ShapeParameter>& parameters,
                              std::size_t which) {
  const model::ShapeParameter& parameter = parameters[which];
  std::vector<model::ShapeParameter> others = parameters;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
  const int points = grid_points(parameter);
  std::vector<double> values;
  for (int i = 0; i < points; ++i) values.push_back(parameter.from_unit((i + 0.5) / points));
  const std::vector<double> costs = problem.costs(parameter, values, others);

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
  for (std::size_t i = 0; i < count; ++i) starts.push_back(values[dips[i]]);
  return starts;
}

// Makes the largest fraction of a step that lowers the cost; `here`, the solution, stays if none
// does.
void go(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
        const Eigen::VectorXd& change, WhitenedProblem::Solution& here) {
  std::vector<double> start;
  for (const model::ShapeParameter& parameter : parameters)
    start.push_back(problem.value(parameter));
  std::vector<double> values = start;
  for (double length = 1; length > 1e-3; length /= 2) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      values[i] = parameters[i].from_unit(parameters[i].to_unit(start[i]) +
                                          length * change[static_cast<Eigen::Index>(i)]);
    }
    problem.set(parameters, values);
    WhitenedProblem::Solution now = problem.solution();
    if (!(now.cost < here.cost)) continue;
    here = std::move(now);
    return;
  }
  problem.set(parameters, start);
}

// Iterates until the expected or the actual relative decrease is below the limit.
double descend(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
               double worth_a_step) {
  WhitenedProblem::Solution here = problem.solution();
  for (int i = 0; i < kGaussNewtonSteps; ++i) {
    const WhitenedProblem::Step step = problem.step(parameters, here);
    const double enough = here.cost * (1 - worth_a_step);
    if (!step.change.allFinite() || !(step.cost < enough)) break;
    go(problem, parameters, step.change, here);
    if (here.cost >= enough) break;
  }
  return here.cost;
}

// Searches one parameter over its whole range and optimises all parameters from each promising
// value. Returns whether it moved to another local minimum.
bool search_range(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
                  std::size_t which) {
  const std::vector<double> elsewhere = starts_of(problem, parameters, which);
  // first from here, then from elsewhere
  std::vector<WhitenedProblem> minima(1 + elsewhere.size(), problem);
  std::vector<double> costs(minima.size());
  for_each_index(minima.size(), [&](std::size_t i) {
    if (i > 0) minima[i].set({parameters[which]}, {elsewhere[i - 1]});
    costs[i] = descend(minima[i], parameters, kRoughly);
  });
  const auto best = std::min_element(costs.begin(), costs.end());
  problem = std::move(minima[static_cast<std::size_t>(best - costs.begin())]);
  return *best < costs[0] * (1 - kRoughly);
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
    if (ranges[i]) elsewhere[i] = search_range(problem, parameters, i);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(parameters.size()));
  }
  descend(problem, parameters, exact ? kConverged : kRoughly);
  order_parts(problem, parameters);
  return elsewhere;
}

}  // namespace fogcomp::fit
