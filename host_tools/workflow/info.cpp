#include "workflow/info.hpp"

#include "diagnosis/decision_rules.hpp"
#include "model/effect_list.hpp"
#include "noise/white_noise.hpp"
#include "recording/plausibility.hpp"
#include "runs/row_length.hpp"
#include "series/signal_series.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {
namespace {

constexpr double kUsualAverageSeconds = 10;

std::vector<planning::VisibleSize> visible_sizes(const compare::RunSummary& summary,
                                                 double length_s) {
  model::Model settings;
  settings.average_s = runs::sufficient_row_s(length_s);
  settings.derivative_tau_s = kDerivativeTau_s;
  const series::BlockSeries blocks = series::make_blocks(summary.blocks);
  series::SignalSeries series(settings, series::Phase::zero);
  series.add(blocks);
  if (series.rows().size() < diagnosis::rules::kMinRows) return {};
  return planning::visible_in(series, model::parse_effects(model::kFirstEffects), blocks.inputs);
}

}  // namespace

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
  outcome.visible = visible_sizes(outcome.summary, length_s);
  return outcome;
}

}  // namespace fogcomp::workflow
