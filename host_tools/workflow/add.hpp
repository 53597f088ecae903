#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/next_step.hpp"
#include "fit/add_effect.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct AddRequest {
  std::string model;                 ///< file
  std::vector<std::string> effects;  ///< each in the syntax of change_effect(); judged together
  std::optional<std::string> expression;  ///< `NAME = EXPRESSION` instead of effects
  std::vector<std::string> runs;          ///< recordings to be fitted
  std::vector<std::string> hold_outs;     ///< runs that judge, instead of cross-validation
  recording::ReadOptions reading;         ///< model_scale_factor is replaced by the model's
  bool run_offsets = false;               ///< a bias for each power-on; the model has their mean
  std::uint64_t seed = 1;                 ///< of the network's initial weights
};

/// Returns the verdict and the refitted model; writes nothing. Throws InputError like
/// change_effects(), read_holdouts() and add_effect().
fit::Addition add(const AddRequest& request, const Observer& observer = {});
/// The same with recordings already read by judging_runs().
fit::Addition add(const AddRequest& request, const diagnosis::JudgingRuns& runs,
                  const Observer& observer = {});
diagnosis::JudgingRuns judging_runs(const AddRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
