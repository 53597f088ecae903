#include "workflow/denoise.hpp"

#include <algorithm>
#include <cmath>

#include "denoise/denoise_parts.hpp"
#include "recording/segments.hpp"

namespace fogcomp::workflow {
namespace {

DenoiseOutcome::MeanAndStd statistics(const std::vector<double>& values,
                                      const recording::RowRange& rows) {
  const auto count = static_cast<double>(rows.size());
  DenoiseOutcome::MeanAndStd result;
  for (std::size_t i = rows.first; i < rows.end; ++i) result.mean_dph += values[i] / count;
  for (std::size_t i = rows.first; i < rows.end; ++i) {
    result.std_dph += std::pow(values[i] - result.mean_dph, 2) / std::max(1.0, count - 1);
  }
  result.std_dph = std::sqrt(result.std_dph);
  return result;
}

// Denoises the parts between gaps separately.
denoise::DenoiseReport denoise_bias(const recording::Recording& recording,
                                    const denoise::DenoiseMethod& method,
                                    std::vector<double>& bias) {
  std::vector<fog::Span<double>> parts;
  for (const recording::RowRange& stretch :
       recording::stretches_of(recording, {0, recording.rows()})) {
    parts.push_back({bias.data() + stretch.first, stretch.size()});
  }
  return denoise::denoise_parts(parts, method, recording.file);
}

}  // namespace

DenoiseOutcome denoise(const DenoiseRequest& request, const Observer& observer) {
  recording::ReadOptions reading = observer.with_observer(request.reading);
  reading.every_row = true;
  DenoiseOutcome outcome{recording::read_recording(request.run, reading), {}, {}};
  recording::Recording& recording = outcome.recording;
  const std::vector<double> before = recording::bias_dph(recording);
  std::vector<double> after = before;
  outcome.report = denoise_bias(recording, request.method, after);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double input_dph = recording.input_rate_dph.empty() ? 0 : recording.input_rate_dph[i];
    recording.rate_dph[i] = after[i] + input_dph;
  }
  for (const recording::Segment& segment : recording::find_segments(recording)) {
    outcome.segments.push_back(
        {segment.name, statistics(before, segment.rows), statistics(after, segment.rows)});
  }
  return outcome;
}

}  // namespace fogcomp::workflow
