#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "judge/prediction.hpp"
#include "judge/rivals.hpp"
#include "judge/rows.hpp"
#include "judge/set_search.hpp"

namespace fogcomp::judge {

/// A set of effects that may be missing; none: the model is complete.
struct Explanation {
  std::vector<Part> parts;             ///< each with its most probable shape
  double probability = 0;              ///< with and without something else beside it
  double something_else = 0;           ///< with it
  double without_it = 0;               ///< the rest
  double explained = 0;                ///< share of what is above the noise, 0..1
  std::size_t largest = 0;             ///< effect that explains most of it
  bool mostly_something_else = false;  ///< smooth functions beside it explain more than all of it

  bool has(std::size_t effect) const;
};

/// Posterior probabilities of explanations of the measured drift: sets of up to three effects, with
/// and without something else (any smooth function of the signals), in noise that is white, flicker
/// and a random walk. All compete in one likelihood: sizes, shapes, noise and the spread of the
/// power-ons' biases are integrated over.
struct Explanations {
  std::vector<Explanation> all;      ///< most probable first; the empty set is among them
  double nothing = 1;                ///< probability that the model is complete
  double something_else = 0;         ///< that something is missing that is none of the effects
  double mostly_something_else = 0;  ///< that this is most of what is missing
  double excess = 0;                 ///< chi^2 above the noise that there is to explain
  double left_by_best = 0;           ///< share of it that the most probable set does not explain
  NoiseLevels noise_if_nothing;      ///< where the model is complete

  struct Effect {
    double probability = 0;              ///< that it is missing, alone or with others
    double largest = 0;                  ///< that it is the largest of those
    double log_odds = 0;                 ///< of it alone against nothing
    std::vector<double> log_likelihood;  ///< of each shape, alone
    std::size_t shape = 0;               ///< the most probable in the likeliest set with it
    double explained = 0;                ///< share of what is above the noise, alone
    double visible_from_dph = 0;         ///< rms over the rows: these would have shown it
  };
  std::vector<Effect> effects;
};

/// `space`: of rows with the model's columns. `something_else`: rows x any number of smooth
/// functions.
Explanations explain(const ModeSpace& space, Eigen::MatrixXd something_else,
                     std::vector<PossibleEffect> effects);

}  // namespace fogcomp::judge
