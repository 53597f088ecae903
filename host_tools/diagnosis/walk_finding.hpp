#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/evidence_space.hpp"

namespace fogcomp::diagnosis {

/// A random walk of the bias as alternative to an effect or other slow structure.
struct WalkFinding {
  double coefficient = 0;        ///< of the likeliest, deg/h/sqrt(h)
  double chance = 0;             ///< that nothing but noise and such a walk is there
  double noise_alone = 1;        ///< if may_be_all(): chance that such noise looks like this
  bool instead_of_time = false;  ///< the likeliest effects are, in part, of time alone
  bool has_static = false;       ///< the slow noise is known from a recording at rest

  /// Whether slow effects must not be accepted because of it.
  bool may_be_all() const {
    return chance >=
           (instead_of_time ? rules::kMaxChanceOfWalkForTime : rules::kMaxChanceOfNamedWalk);
  }
  /// If may_be_all(): what it means and what would tell, about changes that are "them".
  std::string words() const;
};

/// How probable it is that everything slow is a random walk of the bias, against effects and smooth
/// structure, without a walk and beside it. {} without quiet parts: then the slow noise is unknown,
/// and anything could be a walk. `hypotheses`: most probable first.
WalkFinding assess_walk(const EvidenceSpace& evidence, const std::vector<Hypothesis>& hypotheses,
                        const noise::NoiseModel& noise, std::uint64_t seed);

}  // namespace fogcomp::diagnosis
