#include "workflow/info.hpp"

#include "noise/white_noise.hpp"
#include "recording/plausibility.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {
namespace {

constexpr double kUsualAverageSeconds = 10;

}  // namespace

InfoOutcome info(const InfoRequest& request, const Observer& observer) {
  InfoOutcome outcome{
      recording::read_recording(request.run, observer.with_observer(request.reading)), {}};
  const recording::Recording& run = outcome.recording;
  const double length_s = static_cast<double>(run.rows()) * run.period_s;
  if (request.average_s && 2 * *request.average_s > length_s) {
    throw InputError(run.file,
                     format("lasts %g s, too short for means of %g s; give a shorter --average",
                            length_s, *request.average_s));
  }
  observer.say(recording::doubts(run, noise::white_noise_dph_rthz(run)));
  outcome.summary = compare::summarize(run, request.average_s.value_or(kUsualAverageSeconds));
  return outcome;
}

}  // namespace fogcomp::workflow
