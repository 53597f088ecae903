#pragma once

#include <string>

#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct ConvertRequest {
  std::string run;  ///< recording of any layout
  recording::ReadOptions reading;
};

/// The recording with all of its rows, including those that a board would refuse: its readers judge
/// them. Throws InputError like read_recording().
recording::Recording convert(const ConvertRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
