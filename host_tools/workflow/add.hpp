#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/next_step.hpp"
#include "fit/add_effect.hpp"
#include "recording/recording.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {

struct AddRequest : JudgingRequest {
  std::vector<std::string> effects;  ///< each in the syntax of change_effect(); judged together
  std::optional<std::string> expression;  ///< `NAME = EXPRESSION` instead of effects
  bool only_cuts = false;                 ///< the cuts of `reading` instead of effects
  bool run_offsets = false;               ///< a bias for each power-on; the model has their mean
  std::uint64_t seed = 1;                 ///< of the network's initial weights
};

/// Returns the verdict and the refitted model; writes nothing. Throws InputError like
/// change_effects(), runs::read_runs() and add_effect().
fit::Addition add(const AddRequest& request, const Observer& observer = {});
/// The same with recordings already read by judging_runs().
fit::Addition add(const AddRequest& request, const runs::Runs& runs, const Observer& observer = {});

}  // namespace fogcomp::workflow
