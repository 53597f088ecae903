#include "workflow/fit.hpp"

#include <optional>
#include <utility>

#include "fit/derivative_choice.hpp"
#include "fit/turn_on_bias.hpp"
#include "network/network_inputs.hpp"
#include "recording/recording_writer.hpp"
#include "runs/runs.hpp"
#include "series/signal_series.hpp"
#include "support/text.hpp"
#include "workflow/prior.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {
namespace {

const std::string kFittingEffects = "fitting effects";
const std::string kFittingBiases = "fitting effects, each power-on with its own bias";

// Nothing if the rows are not to be denoised.
std::optional<denoise::DenoiseMethod> row_denoising(const FitRequest& request) {
  if (!request.row_denoising) return std::nullopt;
  denoise::DenoiseMethod method;
  method.wavelet = request.board_denoiser.wavelet;
  method.levels = request.board_denoiser.levels;
  method.rule = *request.row_denoising;
  method.hard = request.board_denoiser.hard;
  return method;
}

// Everything that a request defines, before any recording is read.
struct Plan {
  WantedModel wanted;
  fit::FitSettings settings;
  model::Model model;  // without coefficients, or with those of its prior
  recording::ReadOptions reading;
  std::optional<KnownBefore> before;  // which goes on
};

Plan plan_of(const FitRequest& request) {
  Plan plan;
  plan.wanted = wanted_model(request);
  fit::FitSettings& settings = plan.settings;
  settings.identify.run_offsets = request.run_offsets;
  settings.row_denoising = row_denoising(request);
  settings.network = plan.wanted.network;
  settings.force_network = plan.wanted.network_is_the_model || request.force_network;
  settings.network_inputs = network::parse_network_inputs(request.network_inputs);
  plan.before = known_before(request);
  const model::Model before = plan.before ? plan.before->model : model::Model();
  plan.model.history = before.history;
  plan.model.samples = before.samples;  // a lot has none
  plan.model.serial = request.serial.empty() ? before.serial : request.serial;
  plan.model.terms = plan.before ? before.terms : wanted_terms(request);
  plan.model.average_s = request.average_s;
  plan.model.derivative_tau_s =
      plan.before ? before.derivative_tau_s : request.derivative_tau_s.value_or(kDerivativeTau_s);
  plan.model.denoise = request.board_denoiser;
  // needed for reading the runs
  if (plan.wanted.network.hidden > 0) plan.model.network.inputs = settings.network_inputs;
  // The scale factor is also the board's: it is stored for recordings in deg/h as well.
  plan.reading = request.reading;
  if (plan.before && plan.reading.columns.empty()) plan.reading.columns = before.columns;
  if (plan.before && !plan.reading.scale_factor) plan.reading.scale_factor = before.scale_factor;
  plan.reading.model_limits = before.limits;
  plan.model.limits = plan.reading.limits.over(before.limits);
  remember_reading(plan.reading, plan.model);
  plan.model.scale_factor = plan.reading.scale_factor.value_or(recording::kDefaultScaleFactor);
  std::swap(plan.reading.scale_factor, plan.reading.model_scale_factor);
  return plan;
}

// Beside those of its prior.
void count_samples(const std::vector<runs::Run>& training, model::Model& model) {
  const std::vector<std::uint64_t> own = runs::samples_of(training);
  model.samples.insert(model.samples.end(), own.begin(), own.end());
}

// The actions and their results: the effects, then the network.
std::vector<model::HistoryEntry> history_of(const FitOutcome& outcome, const FitRequest& request,
                                            const WantedModel& wanted, const runs::Runs& runs,
                                            double before_dph) {
  const model::Model& model = outcome.model;
  const double effects_rms_dph = outcome.result.effects_rms_dph;
  const fit::Identification& identified = outcome.result.identified;
  std::string fitted = identified.prior ? prior_words(identified) : wanted.effects;
  for (const std::string& definition : request.expressions) fitted += ", " + definition;
  fitted += runs.read_with;
  const std::optional<double> floor_dph = runs.noise_floor_dph(model.average_s);
  std::vector<model::HistoryEntry> history{
      {"fit " + fitted, runs.data_hash, before_dph, effects_rms_dph, floor_dph}};
  if (model.network.present()) {
    history.push_back(
        {format("network %d %s", wanted.network.hidden, wanted.network.trainer.c_str()),
         runs.data_hash, effects_rms_dph, model.residual_rms_dph, floor_dph});
  }
  return history;
}

// Each power-on has its own bias if that is asked for, or if they differ: one for all would bend
// the effects, which then had to make up for it. Sets `settings.run_offsets`, and `turn_on` if it
// was asked of the model that stays.
fit::FitResult fit_effects(model::Model& model, const fit::KnownRegressors& known,
                           fit::IdentifySettings& settings, const std::vector<runs::Run>& training,
                           const Observer& observer, std::optional<compare::TurnOn>& turn_on) {
  const model::Model unfitted = model;
  settings.progress = observer.of_stage(kFittingEffects);
  fit::FitResult result = fit::fit_effects(model, known, settings);
  if (settings.run_offsets) return result;
  turn_on = fit::turn_on_biases(model, training);
  if (!turn_on->can_be_own()) return result;
  turn_on.reset();
  model = unfitted;
  settings.run_offsets = true;
  settings.progress = observer.of_stage(kFittingBiases);
  return fit::fit_effects(model, known, settings);
}

// Nothing where `kept` will do, of runs that have all that the model needs.
std::optional<fit::KnownRegressors> known_here(const model::Model& model,
                                               const std::vector<runs::Run>& training,
                                               const fit::KnownRegressors* kept) {
  if (kept == nullptr) return fit::KnownRegressors(model, training);
  for (const runs::Run& run : training) series::require_inputs(model, run.blocks);
  return std::nullopt;
}

}  // namespace

std::size_t FitOutcome::refused_rows() const {
  std::size_t refused = 0;
  for (const runs::Run& run : runs) refused += run.refused_rows;
  return refused;
}

std::optional<double> FitOutcome::determined_weights() const {
  if (!model.network.present()) return std::nullopt;
  return result.training->effective_parameters;
}

bool FitOutcome::network_dropped() const {
  return result.training && !model.network.present();
}

compare::ModelOnRuns FitOutcome::on_its_runs(const std::string& file) const {
  compare::ModelOnRuns judged{file, model, {}};
  for (const runs::Run& run : runs)
    judged.runs.push_back(compare::try_model(model, run, model.average_s));
  judged.turn_on = turn_on;
  return judged;
}

std::vector<model::EffectTerm> check(const FitRequest& request) {
  return plan_of(request).model.terms;
}

runs::Runs training_runs(const FitRequest& request, const Observer& observer) {
  return runs::read_runs(request.runs, {}, observer.with_observer(plan_of(request).reading),
                         {request.average_s});
}

FitOutcome fit(const FitRequest& request, const Observer& observer) {
  return fit(request, training_runs(request, observer), observer);
}

FitOutcome fit(const FitRequest& request, runs::Runs runs, const Observer& observer,
               const fit::KnownRegressors* kept) {
  auto [wanted, settings, wanted_terms, reading, before] = plan_of(request);
  if (before) settings.identify.prior = before->prior(request, runs.training);
  FitOutcome outcome;
  model::Model& model = outcome.model;
  model = std::move(wanted_terms);
  count_samples(runs.training, model);
  observer.say(runs.notes);
  model.noise_dph_rthz = runs.noise_dph_rthz;
  const std::vector<runs::Run>& training = runs.training;
  std::optional<compare::TurnOn> turn_on;
  {
    // destroyed before the comparison below builds its own: it is large
    const std::optional<fit::KnownRegressors> own = known_here(model, training, kept);
    const fit::KnownRegressors& known = own ? *own : *kept;
    const series::Rows& rows = known.series().rows();
    outcome.rows = rows.size();
    outcome.row_s = rows.row_s;
    if (wanted.order_by_validation) model.terms = with_best_order(std::move(model.terms), rows);
    observer.tell(kFittingEffects, 0);
    outcome.result = fit_effects(model, known, settings.identify, training, observer, turn_on);
    if (before) model = with_ranges_of(before->model, std::move(model));
    if (observer.progress) {
      settings.network.training.go_on = [&](double done) {
        return observer.should_continue(kTraining, done);
      };
    }
    fit::fit_network(model, known, settings, outcome.result);
    observer.should_continue("judging",
                             0);  // the result is kept even if the user has ended the training
    outcome.delay_rms_dph = fit::delay_error_dph(model, known);
    outcome.better_derivative = fit::better_derivative(model, known, training);
  }
  const bool is_known = turn_on && !model.network.present();
  outcome.turn_on = is_known ? std::move(*turn_on) : fit::turn_on_biases(model, training);
  const double before_dph =
      request.prior ? rms_of(before->model, training, model.average_s) : outcome.result.raw_std_dph;
  for (const model::HistoryEntry& entry : history_of(outcome, request, wanted, runs, before_dph))
    model.history.push_back(entry);
  outcome.runs = std::move(runs.training);
  return outcome;
}

}  // namespace fogcomp::workflow
