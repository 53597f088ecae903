#include "fit/shape_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/catalogue.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

constexpr int kGridPoints = 24;
// From 2 to 60 degC: half a turn over 100 degC from each point to the next, as a cosine that is
// half a turn off at the end of the data explains nothing of them.
constexpr int kPeriodGridPoints = 96;
constexpr std::size_t kMostStarts = 3;  // of one parameter
constexpr int kGaussNewtonSteps = 12;
// Relative fall of the cost that is worth another step: to compare starts, and at the end.
constexpr double kRoughly = 1e-5;
constexpr double kConverged = 1e-9;
constexpr double kDifferenceStep = 1e-4;  // of a parameter's range, for derivatives
constexpr double kDependent = 1e-8;

// Of a shape at which an expression overflows: worse than any other.
double finite_or_worst(double cost) {
  return std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity();
}

int grid_points(const model::ShapeParameter& parameter) {
  return parameter.scale == fog::Scale::frequency ? kPeriodGridPoints : kGridPoints;
}

// Where one parameter may belong, the most promising place first: the deepest dips of the cost over
// its grid, but for the dip in which it is.
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
  const std::size_t count = std::min(kMostStarts, dips.size());
  std::partial_sort(dips.begin(), dips.begin() + static_cast<std::ptrdiff_t>(count), dips.end(),
                    [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  std::vector<double> starts;
  for (std::size_t i = 0; i < count; ++i) starts.push_back(values[dips[i]]);
  return starts;
}

// One step from where the cost is given; returns the new one, the same where none lowers it.
double gauss_newton_step(WhitenedProblem& problem,
                         const std::vector<model::ShapeParameter>& parameters, double cost) {
  const Eigen::MatrixXd jacobian = problem.jacobian(parameters);
  const LinearFit fit = solve_linear(jacobian, problem.measured());
  if (!fit.coefficients.allFinite()) return cost;
  std::vector<double> start;
  for (const model::ShapeParameter& parameter : parameters)
    start.push_back(problem.value(parameter));
  const Eigen::Index first = jacobian.cols() - static_cast<Eigen::Index>(parameters.size());
  for (double length = 1; length > 1e-3; length /= 2) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double step = fit.coefficients[first + static_cast<Eigen::Index>(i)];
      problem.set(parameters[i],
                  parameters[i].from_unit(parameters[i].to_unit(start[i]) + length * step));
    }
    const double now = problem.cost();
    if (now < cost) return now;
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) problem.set(parameters[i], start[i]);
  return cost;
}

double descend(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
               double worth_a_step) {
  double cost = problem.cost();
  for (int step = 0; step < kGaussNewtonSteps; ++step) {
    const double before = cost;
    cost = gauss_newton_step(problem, parameters, before);
    if (cost >= before * (1 - worth_a_step)) break;
  }
  return cost;
}

// Tries one parameter over its whole range; from each promising place all go downhill together.
void search_range(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
                  std::size_t which) {
  const WhitenedProblem before = problem;
  double least_cost = descend(problem, parameters, kRoughly);
  WhitenedProblem best = problem;
  for (const double start : starts_of(before, parameters, which)) {
    problem = before;
    problem.set(parameters[which], start);
    const double cost = descend(problem, parameters, kRoughly);
    if (cost >= least_cost) continue;
    least_cost = cost;
    best = problem;
  }
  problem = best;
}

// The two parts of an effect that may have a second one (radii, periods) are the same in either
// order; the smaller is the first. Only where both were searched in the same range, so that no
// bound is left.
bool is_second_part(const model::EffectTerm& term, std::size_t parameter) {
  return !term.expression &&
         model::is_optional_part(model::find_effect(term.name).parameters[parameter]);
}
void order_parts(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters) {
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const model::ShapeParameter& first = parameters[i - 1];
    const model::ShapeParameter& second = parameters[i];
    if (first.term != second.term || !is_second_part(problem.terms()[second.term], second.index) ||
        first.least != second.least || first.most != second.most) {
      continue;
    }
    const double smaller = std::min(problem.value(first), problem.value(second));
    const double larger = std::max(problem.value(first), problem.value(second));
    problem.set(first, smaller);
    problem.set(second, larger);
  }
}

}  // namespace

WhitenedProblem::WhitenedProblem(const series::SignalSeries& series,
                                 const noise::Whitening& whitening,
                                 std::vector<model::EffectTerm> terms,
                                 const Eigen::MatrixXd& nuisance)
    : series_(&series),
      whitening_(&whitening),
      terms_(std::move(terms)),
      measured_(whitening.apply(series.rows().drift_dph)) {
  for (const model::EffectTerm& term : terms_) columns_.push_back(whitened(term));
  columns_.push_back(whitening.apply(nuisance));
}

Eigen::MatrixXd WhitenedProblem::whitened(const model::EffectTerm& term,
                                          series::Reading reading) const {
  return whitening_->apply(series_->regressors(term, reading));
}

double WhitenedProblem::value(const model::ShapeParameter& parameter) const {
  return terms_[parameter.term].parameters[parameter.index];
}

void WhitenedProblem::set(const model::ShapeParameter& parameter, double value) {
  terms_[parameter.term].parameters[parameter.index] = value;
  columns_[parameter.term] = whitened(terms_[parameter.term]);
}

Eigen::MatrixXd WhitenedProblem::matrix() const {
  Eigen::Index width = 0;
  for (const Eigen::MatrixXd& columns : columns_) width += columns.cols();
  Eigen::MatrixXd all(measured_.size(), width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& columns : columns_) {
    all.middleCols(at, columns.cols()) = columns;
    at += columns.cols();
  }
  return all;
}

LinearFit WhitenedProblem::solve(const std::vector<model::ShapeParameter>& parameters) const {
  const Eigen::MatrixXd columns = jacobian(parameters);
  if (series_->phase() == series::Phase::zero) return solve_linear(columns, measured_);
  Eigen::MatrixXd instruments = columns;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    instruments.middleCols(first_column(i), columns_[i].cols()) =
        whitened(terms_[i], series::Reading::smoothed);
  }
  return solve_with_instruments(columns, instruments, measured_);
}

double WhitenedProblem::cost() const {
  return finite_or_worst(solve_linear(matrix(), measured_).residual.squaredNorm());
}

Eigen::Index WhitenedProblem::first_column(std::size_t term) const {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < term; ++i) first += columns_[i].cols();
  return first;
}

std::vector<double> WhitenedProblem::costs(const model::ShapeParameter& parameter,
                                           const std::vector<double>& values,
                                           const std::vector<model::ShapeParameter>& others) const {
  const Eigen::MatrixXd all = jacobian(others);
  const Eigen::Index first = first_column(parameter.term);
  const Eigen::Index behind = all.cols() - first - columns_[parameter.term].cols();
  const Eigen::MatrixXd basis = orthonormal(
      side_by_side({all.leftCols(first), all.rightCols(behind)}, all.rows()), kDependent);
  const auto without = [&](Eigen::MatrixXd columns) -> Eigen::MatrixXd {
    columns -= basis * (basis.transpose() * columns).eval();
    return columns;
  };
  const Eigen::VectorXd left = without(measured_);
  model::EffectTerm moved = terms_[parameter.term];
  std::vector<double> costs;
  for (const double value : values) {
    moved.parameters[parameter.index] = value;
    costs.push_back(
        finite_or_worst(solve_linear(without(whitened(moved)), left).residual.squaredNorm()));
  }
  return costs;
}

Eigen::MatrixXd WhitenedProblem::jacobian(
    const std::vector<model::ShapeParameter>& parameters) const {
  const Eigen::MatrixXd linear = matrix();
  if (parameters.empty()) return linear;
  const Eigen::VectorXd coefficients = solve_linear(linear, measured_).coefficients;
  Eigen::MatrixXd all(linear.rows(), linear.cols() + static_cast<Eigen::Index>(parameters.size()));
  all.leftCols(linear.cols()) = linear;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const model::ShapeParameter& parameter = parameters[i];
    const Eigen::VectorXd part =
        coefficients.segment(first_column(parameter.term), columns_[parameter.term].cols());
    model::EffectTerm moved = terms_[parameter.term];
    const double unit = parameter.to_unit(moved.parameters[parameter.index]);
    const double up = std::min(unit + kDifferenceStep, 1.0);
    const double down = std::max(unit - kDifferenceStep, 0.0);
    moved.parameters[parameter.index] = parameter.from_unit(up);
    const Eigen::VectorXd above = whitened(moved) * part;
    moved.parameters[parameter.index] = parameter.from_unit(down);
    all.col(linear.cols() + static_cast<Eigen::Index>(i)) =
        (above - whitened(moved) * part) / (up - down);
  }
  return all;
}

void search_shapes(WhitenedProblem& problem, const std::vector<model::ShapeParameter>& parameters,
                   const std::function<void(double)>& progress) {
  if (parameters.empty()) return;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    search_range(problem, parameters, i);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(parameters.size()));
  }
  descend(problem, parameters, kConverged);
  order_parts(problem, parameters);
}

}  // namespace fogcomp::fit
