#include "identification/shape_search.hpp"

#include <algorithm>
#include <cmath>

#include "identification/least_squares.hpp"
#include "model/catalogue.hpp"

namespace fogcomp {
namespace {

constexpr double kRatioForLogarithm = 20;
constexpr int kGridPoints = 24;
// From 2 to 60 degC: half a turn over 100 degC from each point to the next, as a cosine that is
// half a turn off at the end of the data explains nothing of them.
constexpr int kPeriodGridPoints = 96;
constexpr int kGridRounds = 2;
constexpr int kGaussNewtonSteps = 12;
constexpr double kConverged = 1e-9;       // relative fall of the cost
constexpr double kDifferenceStep = 1e-4;  // of a parameter's range, for derivatives

void search_grid(WhitenedProblem& problem, const ShapeParameter& parameter) {
  double best = problem.value(parameter);
  double least_cost = problem.cost();
  const int points =
      parameter.scale == ShapeParameter::Scale::frequency ? kPeriodGridPoints : kGridPoints;
  for (int i = 0; i < points; ++i) {
    const double value = parameter.from_unit((i + 0.5) / points);
    problem.set(parameter, value);
    const double cost = problem.cost();
    if (cost < least_cost) {
      least_cost = cost;
      best = value;
    }
  }
  problem.set(parameter, best);
}

// One step; false where none lowers the cost any more.
bool gauss_newton_step(WhitenedProblem& problem, const std::vector<ShapeParameter>& parameters) {
  const double cost = problem.cost();
  const Eigen::MatrixXd jacobian = problem.jacobian(parameters);
  const LinearFit fit = solve_linear(jacobian, problem.measured());
  std::vector<double> start;
  for (const ShapeParameter& parameter : parameters) start.push_back(problem.value(parameter));
  const Eigen::Index first = jacobian.cols() - static_cast<Eigen::Index>(parameters.size());
  for (double length = 1; length > 1e-3; length /= 2) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double step = fit.coefficients[first + static_cast<Eigen::Index>(i)];
      problem.set(parameters[i],
                  parameters[i].from_unit(parameters[i].to_unit(start[i]) + length * step));
    }
    if (problem.cost() < cost) return problem.cost() < cost * (1 - kConverged);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) problem.set(parameters[i], start[i]);
  return false;
}

ShapeParameter::Scale scale_of(const std::string& name, const ShapeBounds& bounds) {
  if (name.rfind("period", 0) == 0 && bounds.least > 0) return ShapeParameter::Scale::frequency;
  const bool far = bounds.least > 0 && bounds.most / bounds.least >= kRatioForLogarithm;
  return far ? ShapeParameter::Scale::ratio : ShapeParameter::Scale::linear;
}

// The two parts of an effect that may have a second one (radii, periods) are the same in either
// order; the smaller is the first. Only where both were searched in the same range, so that no
// bound is left.
bool is_second_part(const EffectTerm& term, std::size_t parameter) {
  return !term.expression && find_effect(term.name).parameters[parameter].default_milli == 0;
}
void order_parts(WhitenedProblem& problem, const std::vector<ShapeParameter>& parameters) {
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    const ShapeParameter& first = parameters[i - 1];
    const ShapeParameter& second = parameters[i];
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

double ShapeParameter::to_unit(double value) const {
  switch (scale) {
    case Scale::ratio:
      return std::log(value / least) / std::log(most / least);
    case Scale::frequency:
      return (1 / least - 1 / value) / (1 / least - 1 / most);
    case Scale::linear:
      break;
  }
  return (value - least) / (most - least);
}

double ShapeParameter::from_unit(double unit) const {
  const double u = std::clamp(unit, 0.0, 1.0);
  switch (scale) {
    case Scale::ratio:
      return least * std::pow(most / least, u);
    case Scale::frequency:
      return 1 / (1 / least - u * (1 / least - 1 / most));
    case Scale::linear:
      break;
  }
  return least + u * (most - least);
}

double ShapeParameter::slope(double value) const {
  switch (scale) {
    case Scale::ratio:
      return value * std::log(most / least);
    case Scale::frequency:
      return value * value * (1 / least - 1 / most);
    case Scale::linear:
      break;
  }
  return most - least;
}

std::vector<ShapeParameter> shape_parameters(const std::vector<EffectTerm>& terms) {
  std::vector<ShapeParameter> parameters;
  for (std::size_t term = 0; term < terms.size(); ++term) {
    if (is_event(terms[term])) continue;
    const TermInfo entry = info_of(terms[term]);
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      if (!terms[term].identified[i]) continue;
      const auto& own = terms[term].bounds;
      const bool bounded = i < own.size() && own[i].most > own[i].least;
      const ShapeBounds bounds = bounded ? own[i] : entry.parameters[i].bounds;
      parameters.push_back(
          {term, i, bounds.least, bounds.most, scale_of(entry.parameters[i].name, bounds)});
    }
  }
  return parameters;
}

WhitenedProblem::WhitenedProblem(const SignalSeries& series, const Whitening& whitening,
                                 std::vector<EffectTerm> terms, const Eigen::MatrixXd& nuisance)
    : series_(series),
      whitening_(whitening),
      terms_(std::move(terms)),
      measured_(whitening.apply(series.rows().drift_dph)) {
  for (const EffectTerm& term : terms_) columns_.push_back(whitened(term));
  columns_.push_back(whitening.apply(nuisance));
}

Eigen::MatrixXd WhitenedProblem::whitened(const EffectTerm& term) const {
  return whitening_.apply(series_.regressors(term));
}

double WhitenedProblem::value(const ShapeParameter& parameter) const {
  return terms_[parameter.term].parameters[parameter.index];
}

void WhitenedProblem::set(const ShapeParameter& parameter, double value) {
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

double WhitenedProblem::cost() const {
  return solve_linear(matrix(), measured_).residual.squaredNorm();
}

Eigen::MatrixXd WhitenedProblem::jacobian(const std::vector<ShapeParameter>& parameters) const {
  const Eigen::MatrixXd linear = matrix();
  const Eigen::VectorXd coefficients = solve_linear(linear, measured_).coefficients;
  Eigen::MatrixXd all(linear.rows(), linear.cols() + static_cast<Eigen::Index>(parameters.size()));
  all.leftCols(linear.cols()) = linear;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ShapeParameter& parameter = parameters[i];
    Eigen::Index first = 0;
    for (std::size_t term = 0; term < parameter.term; ++term) first += columns_[term].cols();
    const Eigen::VectorXd part = coefficients.segment(first, columns_[parameter.term].cols());
    EffectTerm moved = terms_[parameter.term];
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

void search_shapes(WhitenedProblem& problem, const std::vector<ShapeParameter>& parameters,
                   const std::function<void(double)>& progress) {
  if (parameters.empty()) return;
  const auto searches = static_cast<double>(kGridRounds) * static_cast<double>(parameters.size());
  double done = 0;
  for (int round = 0; round < kGridRounds; ++round) {
    for (const ShapeParameter& parameter : parameters) {
      search_grid(problem, parameter);
      if (progress) progress(++done / searches);
    }
  }
  for (int step = 0; step < kGaussNewtonSteps; ++step) {
    if (!gauss_newton_step(problem, parameters)) break;
  }
  order_parts(problem, parameters);
}

}  // namespace fogcomp
