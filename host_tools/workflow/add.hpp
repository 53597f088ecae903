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
  std::string model;                      ///< file
  std::vector<std::string> effects;       ///< each as change_effect() takes it; judged together
  std::optional<std::string> expression;  ///< `NAME = EXPRESSION` instead of effects
  std::vector<std::string> runs;          ///< recordings to fit to
  std::vector<std::string> hold_outs;     ///< to judge by, instead of leaving parts out
  recording::ReadOptions reading;         ///< model_scale_factor is the model's
  bool run_offsets = false;               ///< every recording has a bias of its own
  std::uint64_t seed = 1;                 ///< of the network's first weights
};

/// Whether the effects are worth it is in the outcome, with the refitted model; nothing is written.
/// Throws InputError as change_effects(), read_holdouts() and add_effect() do.
fit::Addition add(const AddRequest& request, const Observer& observer = {});
/// The same with the request's recordings read before, as judging_runs() does.
fit::Addition add(const AddRequest& request, const diagnosis::JudgingRuns& runs,
                  const Observer& observer = {});
diagnosis::JudgingRuns judging_runs(const AddRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
