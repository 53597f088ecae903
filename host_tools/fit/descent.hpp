#pragma once

#include <vector>

#include "fit/whitened_problem.hpp"
#include "model/shape_parameter.hpp"

namespace fogcomp::fit {

/// A search downhill over shape parameters, within their ranges: Gauss-Newton steps whose length is
/// found by interpolation. It ends when the expected or the actual relative decrease of a step is
/// below a limit.
class Descent {
 public:
  /// `worth_a_step`: smallest relative decrease of the cost that justifies another step.
  Descent(const WhitenedProblem& problem, std::vector<model::ShapeParameter> parameters,
          double worth_a_step);

  void step();
  void finish();
  /// Ends it if it could hardly come down to this cost.
  void abandon_if_above(double cost);

  bool ended() const { return ended_; }
  double cost() const { return here_.cost; }
  WhitenedProblem& problem() { return problem_; }

 private:
  /// A step of those parameters that no bound stops.
  struct Move {
    std::vector<model::ShapeParameter> parameters;
    std::vector<double> start;  // positions in the range, 0..1
    WhitenedProblem::Step step;
  };
  Move next_move() const;
  static double fraction_within_ranges(const Move& move);
  void go(const Move& move, double whole);
  void set(const Move& move, double fraction);

  WhitenedProblem problem_;
  std::vector<model::ShapeParameter> parameters_;
  double worth_a_step_;
  WhitenedProblem::Solution here_;
  double promised_ = 0;  // decrease of the cost, of the last step
  int steps_ = 0;
  bool ended_ = false;
};

}  // namespace fogcomp::fit
