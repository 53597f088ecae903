#pragma once

#include <string>
#include <vector>

#include "denoise/denoise.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct DenoiseRequest {
  std::string run;  ///< recording
  recording::ReadOptions reading;
  denoise::DenoiseMethod method;
};

struct DenoiseOutcome {
  struct MeanAndStd {
    double mean_dph = 0;
    double std_dph = 0;
  };
  struct SegmentBias {
    std::string name;
    MeanAndStd raw;
    MeanAndStd denoised;
  };
  recording::Recording recording;  ///< denoised; what the gyro really turned is in it untouched
  denoise::DenoiseReport report;
  std::vector<SegmentBias> segments;
};

/// Throws InputError as read_recording() and denoise_parts() do.
DenoiseOutcome denoise(const DenoiseRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
