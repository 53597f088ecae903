#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/run_summary.hpp"
#include "planning/information.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct InfoRequest {
  std::string run;  ///< recording
  recording::ReadOptions reading;
  /// Length of a block mean, seconds, > 0; nothing: 10 s for any recording.
  std::optional<double> average_s;
};

struct InfoOutcome {
  recording::Recording recording;
  compare::RunSummary summary;
  /// From which size on it shows each effect beside model::kFirstEffects; empty if it is too short.
  std::vector<planning::VisibleSize> visible;
};

/// Throws InputError like read_recording(), and for a recording without two means of average_s.
InfoOutcome info(const InfoRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
