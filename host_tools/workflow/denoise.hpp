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
  recording::Recording recording;  ///< denoised; its input rate is unchanged
  denoise::DenoiseReport report;
  std::vector<SegmentBias> segments;
};

/// Throws InputError like read_recording() and denoise_parts().
DenoiseOutcome denoise(const DenoiseRequest& request, const Observer& observer = {});

}  // namespace fogcomp::workflow
