#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "compare/run_in_blocks.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct CompareRequest {
  std::vector<std::string> models;  ///< files; at least one
  std::vector<std::string> runs;    ///< recordings
  recording::ReadOptions reading;   ///< model_scale_factor is the models'
  std::optional<double> average_s;  ///< rows of the residual; nothing: as the first was fitted
  bool physics_alone = false;       ///< without the models' networks
};

/// Every model on every run, in the same rows; a run with the rows of one before it is left out,
/// and noted. Throws InputError where a run lacks what a model needs, and for models of different
/// scale factors where reading has none.
std::vector<compare::ModelOnRuns> compare(const CompareRequest& request,
                                          const Observer& observer = {});
/// The same with the request's recordings read before, as compared_runs() does.
std::vector<compare::ModelOnRuns> compare(const CompareRequest& request,
                                          const std::vector<compare::RunInBlocks>& runs,
                                          const Observer& observer = {});
std::vector<compare::RunInBlocks> compared_runs(const CompareRequest& request,
                                                const Observer& observer = {});

}  // namespace fogcomp::workflow
