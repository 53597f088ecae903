#include "fit/descent.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace fogcomp::fit {
namespace {

constexpr int kMaxSteps = 12;
constexpr double kSmallestFraction = 1e-3;  // of a step
// A descent is abandoned if so many times what its last step promised would not bring it to the
// best other one. Steps that converge as slowly as 0.9 a step still bring less than that.
constexpr double kPromises = 10;

// Fraction of a step at which the cost is smallest, by the parabola through the cost found at
// `fraction` and the cost and its slope at the step's beginning (Dennis and Schnabel, Numerical
// Methods for Unconstrained Optimization, A6.3.1). The slope is twice the decrease that the
// linearised problem promises of the whole step.
double best_fraction(double promised, double fraction, double decrease) {
  const double curvature = (2 * promised * fraction - decrease) / (fraction * fraction);
  return curvature > 0 ? promised / curvature : std::numeric_limits<double>::infinity();
}

// Largest fraction of a step, at most 1, that keeps a parameter within its range.
double fraction_within_range(double unit, double change) {
  if (change > 1 - unit) return (1 - unit) / change;
  if (change < -unit) return unit / -change;
  return 1;
}

}  // namespace

Descent::Descent(const WhitenedProblem& problem, std::vector<model::ShapeParameter> parameters,
                 double worth_a_step)
    : problem_(problem),
      parameters_(std::move(parameters)),
      worth_a_step_(worth_a_step),
      here_(problem_.solution()) {}

Descent::Move Descent::next_move() const {
  Move move;
  std::vector<model::ShapeParameter> free = parameters_;
  while (move.parameters.size() != free.size()) {
    move = {std::exchange(free, {}), {}, {}};
    move.step = problem_.step(move.parameters, here_);
    for (std::size_t i = 0; i < move.parameters.size(); ++i) {
      const model::ShapeParameter& parameter = move.parameters[i];
      move.start.push_back(std::clamp(parameter.to_unit(problem_.value(parameter)), 0.0, 1.0));
      const double change = move.step.change[static_cast<Eigen::Index>(i)];
      const bool stopped = fraction_within_range(move.start[i], change) < kSmallestFraction;
      if (!stopped) free.push_back(parameter);
    }
  }
  return move;
}

void Descent::set(const Move& move, double fraction) {
  std::vector<double> values;
  for (std::size_t i = 0; i < move.parameters.size(); ++i) {
    const double change = move.step.change[static_cast<Eigen::Index>(i)];
    values.push_back(move.parameters[i].from_unit(move.start[i] + fraction * change));
  }
  problem_.set(move.parameters, values);
}

double Descent::fraction_within_ranges(const Move& move) {
  double fraction = 1;
  for (std::size_t i = 0; i < move.parameters.size(); ++i) {
    const double change = move.step.change[static_cast<Eigen::Index>(i)];
    fraction = std::min(fraction, fraction_within_range(move.start[i], change));
  }
  return fraction;
}

// Takes the part of a step, at first `whole` of it, that lowers the cost most; none if none lowers
// it.
void Descent::go(const Move& move, double whole) {
  for (double fraction = whole; fraction > kSmallestFraction * whole;) {
    set(move, fraction);
    WhitenedProblem::Solution now = problem_.solution();
    const double best = best_fraction(promised_, fraction, here_.cost - now.cost);
    if (!(now.cost < here_.cost)) {
      fraction = std::clamp(best, 0.1 * fraction, 0.5 * fraction);
      continue;
    }
    if (here_.cost - promised_ * best < now.cost * (1 - worth_a_step_)) {
      set(move, std::min(best, 2 * fraction));
      WhitenedProblem::Solution there = problem_.solution();
      if (there.cost < now.cost) {
        now = std::move(there);
      } else {
        set(move, fraction);
      }
    }
    here_ = std::move(now);
    return;
  }
  set(move, 0);
}

void Descent::step() {
  const Move move = next_move();
  const double before = here_.cost;
  promised_ = before - move.step.cost;
  const double limit = worth_a_step_ * before;
  ended_ = true;
  if (move.parameters.empty() || !move.step.change.allFinite() || !(promised_ > limit)) return;
  const double whole = fraction_within_ranges(move);
  go(move, whole);
  // A step that was cut short by a range says nothing of the next one, without that parameter.
  ended_ = ++steps_ == kMaxSteps || before - here_.cost <= (whole < 1 ? 0 : limit);
}

void Descent::finish() {
  while (!ended_) step();
}

void Descent::abandon_if_above(double cost) {
  ended_ = ended_ || here_.cost - kPromises * promised_ > cost;
}

}  // namespace fogcomp::fit
