#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "recording/recording.hpp"
#include "runs/runs.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct CompareRequest {
  std::vector<std::string> models;  ///< files; at least one
  std::vector<std::string> runs;    ///< recordings
  recording::ReadOptions reading;   ///< model_scale_factor is replaced by the models'
  std::optional<double> average_s;  ///< rows of the residual; nothing: as in the first model's fit
  bool physics_alone = false;       ///< without the models' networks
};

/// Applies every model to every run, in the same rows. A run with the rows of an earlier one is
/// left out, one that continues another is joined to it (runs/runs.hpp), with a note.
/// Throws InputError if a run lacks an input of a model, and for models of different scale factors
/// if `reading` has none.
std::vector<compare::ModelOnRuns> compare(const CompareRequest& request,
                                          const Observer& observer = {});
/// The same with recordings already read by compared_runs().
std::vector<compare::ModelOnRuns> compare(const CompareRequest& request, const runs::Runs& runs,
                                          const Observer& observer = {});
/// The runs to be compared with, as Runs::holdouts.
runs::Runs compared_runs(const CompareRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
