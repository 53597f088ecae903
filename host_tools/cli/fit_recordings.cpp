// What a fit is, for the commands that make one: options in, model out.

#include "cli/fit_recordings.hpp"

#include <algorithm>
#include <optional>

#include "cli/fit_models.hpp"
#include "cli/recording_options.hpp"
#include "cli/training_options.hpp"
#include "compare/board_delay.hpp"
#include "denoise/filters.hpp"
#include "fit/network_inputs.hpp"
#include "fit/training_runs.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/network.hpp"
#include "recording/recording_writer.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// Nothing where the rows are to stay as they are.
std::optional<DenoiseMethod> row_denoising(const FitOptions& options) {
  const std::optional<ThresholdRule> rule = options.denoise_rows.value();
  if (!rule) return std::nullopt;
  if (options.levels.value() == 0) options.fail("--levels '0' is not a number from 1 to 10");
  DenoiseMethod method;
  method.wavelet = options.wavelet.value();
  method.levels = options.levels.value();
  method.rule = *rule;
  method.hard = options.mode.value();
  return method;
}

// The segment of a recording in which a time lies.
std::string segment_at(const RunInBlocks& run, double time_s) {
  std::string name;
  for (const Segment& segment : run.segments) {
    if (name.empty() || time_s >= segment.start_s) name = segment.name;
  }
  return name;
}

std::string fitted(const FitOptions& options, const std::string& effects) {
  std::string text = effects;
  for (const std::string& definition : options.expressions.value()) text += ", " + definition;
  return text;
}

// What the options ask for, as a model without coefficients.
Model model_settings(const FitOptions& options, const std::string& effects) {
  Model model;
  model.terms = parse_effects(effects);
  for (const std::string& definition : options.expressions.value()) {
    add_expression(model.terms, definition);
  }
  model.average_s = options.average.value();
  model.derivative_tau_s = options.derivative_tau.value();
  model.denoise = {options.wavelet.value(), options.levels.value(), options.threshold.value(),
                   options.mode.value()};
  return model;
}

// All that the options say, before any recording is read.
struct FitPlan {
  WantedModel wanted;
  FitSettings settings;
  Model model;  // without coefficients
  ReadOptions reading;
};

FitPlan plan_fit(const FitOptions& options, const RecordingOptions& recording) {
  FitPlan plan;
  plan.wanted = wanted_model(options);
  FitSettings& settings = plan.settings;
  settings.identify.run_offsets = options.run_offsets.given();
  settings.row_denoising = row_denoising(options);
  settings.network = plan.wanted.network;
  settings.force_network =
      plan.wanted.network_is_the_model || options.training.force_network.given();
  settings.network_inputs = parse_network_inputs(options.inputs.value());
  plan.model = model_settings(options, plan.wanted.effects);
  // Runs need these.
  if (plan.wanted.network.hidden > 0) plan.model.network.inputs = settings.network_inputs;
  // Here the scale factor is the board's too: it counts for recordings in deg/h as well.
  plan.reading = recording.value();
  plan.model.scale_factor = plan.reading.scale_factor.value_or(kDefaultScaleFactor);
  std::swap(plan.reading.scale_factor, plan.reading.model_scale_factor);
  return plan;
}

}  // namespace

Choice<std::optional<ThresholdRule>>::Meanings FitOptions::row_rules() {
  Choice<std::optional<ThresholdRule>>::Meanings rules;
  for (const std::string& name : threshold_rule_names()) {
    rules.emplace_back(name, threshold_rule(name));
  }
  rules.emplace_back("none", std::nullopt);
  return rules;
}

void check_fit_options(const FitOptions& options, const RecordingOptions& recording) {
  plan_fit(options, recording);
}

Fit fit_recordings(const FitOptions& options, const RecordingOptions& recording,
                   const std::vector<std::string>& files, OnInterrupt on_interrupt) {
  auto [wanted, settings, wanted_terms, reading] = plan_fit(options, recording);
  Fit fit;
  Model& model = fit.model;
  model = std::move(wanted_terms);
  fit.searched_steps = searches_steps(model.terms);
  TrainingRuns training = read_training_runs(files, reading, model.average_s);
  print_notes(training.notes);
  model.noise_dph_rthz = training.noise_dph_rthz;
  SignalSeries series(model);
  for (const RunInBlocks& run : training.runs) series.add(run.blocks);
  fit.rows = series.rows().size();
  fit.row_s = series.rows().row_s;
  if (wanted.order_by_validation) choose_order(model.terms, series.rows());
  {
    std::optional<Progress> effects;
    std::optional<TrainingWatch> watch;
    if (on_interrupt == OnInterrupt::keep_best) {
      effects.emplace("fitting effects");
      settings.identify.progress = [&](double done) { effects->update(done); };
      watch.emplace(settings.network.training);
    }
    fit.result = fit_model(model, series, settings);
    if (watch && fit.result.training) watch->report(*fit.result.training);
  }

  fit.delay_rms_dph = delay_error_dph(model, training.runs);
  fit.physical_lags = physical_lags(model, training.runs, settings.identify.run_offsets);
  for (const FoundStep& step : fit.result.identified.steps) {
    const RunInBlocks& run = training.runs[step.run];
    fit.step_places.push_back(run.file + ", " + segment_at(run, step.time_s));
  }

  const double effects_rms_dph = fit.result.effects_rms_dph;
  model.history.push_back({"fit " + fitted(options, wanted.effects), training.data_hash,
                           fit.result.raw_std_dph, effects_rms_dph, training.noise_floor_dph});
  if (model.network.present()) {
    model.history.push_back(
        {format("network %d %s", wanted.network.hidden, wanted.network.trainer.c_str()),
         training.data_hash, effects_rms_dph, model.residual_rms_dph, training.noise_floor_dph});
  }
  fit.runs = std::move(training.runs);
  return fit;
}

}  // namespace fogcomp::cli
