#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/run_summary.hpp"
#include "denoise/denoise.hpp"
#include "planning/first_model.hpp"
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

struct InfoRequest {
  std::string run;  ///< recording
  recording::ReadOptions reading;
  /// Length of a block mean, seconds, > 0; nothing: 10 s for any recording.
  std::optional<double> average_s;
};

struct InfoOutcome {
  recording::Recording recording;
  compare::RunSummary summary;
  planning::Prospect prospect;  ///< of too short a recording, the usual one
};

/// Throws InputError like read_recording(), and for a recording without two means of average_s.
InfoOutcome info(const InfoRequest& request, const Observer& observer = {});

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
