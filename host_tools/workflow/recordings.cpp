#include "workflow/recordings.hpp"

#include <algorithm>
#include <cmath>

#include "denoise/denoise_parts.hpp"
#include "diagnosis/decision_rules.hpp"
#include "noise/noise_floor.hpp"
#include "recording/reading.hpp"
#include "recording/segments.hpp"
#include "runs/run.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {
namespace {

constexpr double kUsualAverageSeconds = 10;

planning::Prospect prospect_of(const compare::RunSummary& summary, double length_s) {
  const series::BlockSeries blocks = series::make_blocks(summary.blocks);
  const double row_s = runs::sufficient_row_s(length_s);
  if (length_s < diagnosis::rules::kMinRows * row_s) return {};
  return planning::prospect_of(blocks, row_s, kDerivativeTau_s);
}

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

recording::Recording convert(const ConvertRequest& request, const Observer& observer) {
  recording::ReadOptions reading = observer.with_observer(request.reading);
  reading.keep_refused_rows = true;
  reading.every_row = true;
  return recording::read_recording(request.run, reading);
}

InfoOutcome info(const InfoRequest& request, const Observer& observer) {
  InfoOutcome outcome{
      recording::read_recording(request.run, observer.with_observer(request.reading)), {}, {}};
  const recording::Recording& run = outcome.recording;
  const double length_s = static_cast<double>(run.rows()) * run.period_s;
  if (request.average_s && 2 * *request.average_s > length_s) {
    throw InputError(run.file,
                     format("lasts %g s, too short for means of %g s; give a shorter --average",
                            length_s, *request.average_s));
  }
  observer.say(recording::doubts(run, noise::white_noise_dph_rthz(run)));
  outcome.summary = compare::summarize(run, request.average_s.value_or(kUsualAverageSeconds));
  outcome.prospect = prospect_of(outcome.summary, length_s);
  return outcome;
}

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
