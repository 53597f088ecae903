#pragma once

#include <string>

#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct ConvertRequest {
  std::string run;  ///< recording of any layout
  recording::ReadOptions reading;
};

/// The recording with all of its rows, those that a board would refuse included: whoever reads it
/// judges them. Throws InputError as read_recording() does.
recording::Recording convert(const ConvertRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
