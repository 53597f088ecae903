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
std::optional<DenoiseMethod> row_denoising(const Arguments& arguments) {
  const std::string rule = arguments.choice("denoise-rows");
  if (rule == "none") return std::nullopt;
  DenoiseMethod method;
  method.wavelet = arguments.choice("wavelet");
  method.levels = static_cast<int>(arguments.integer("levels", 1, 10));
  method.rule = threshold_rule(rule);
  method.hard = arguments.choice("mode") == "hard";
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

std::string fitted(const Arguments& arguments, const std::string& effects) {
  std::string text = effects;
  for (const std::string& definition : arguments.all("effect-expr")) text += ", " + definition;
  return text;
}

// What the options ask for, as a model without coefficients.
Model model_settings(const Arguments& arguments, const std::string& effects) {
  Model model;
  model.terms = parse_effects(effects);
  for (const std::string& definition : arguments.all("effect-expr")) {
    add_expression(model.terms, definition);
  }
  model.average_s = arguments.number("average", 1e-3, 1e6);
  model.derivative_tau_s = arguments.number("derivative-tau", 1e-3, 1e5);
  model.denoise.wavelet = arguments.choice("wavelet");
  model.denoise.levels = static_cast<int>(arguments.integer("levels", 0, 10));
  const std::string rule = arguments.choice("threshold");
  model.denoise.rule = static_cast<fog::ThresholdRule>(
      std::find(kBoardRules.begin(), kBoardRules.end(), rule) - kBoardRules.begin());
  model.denoise.hard = arguments.choice("mode") == "hard";
  return model;
}

// All that the options say, before any recording is read.
struct FitPlan {
  WantedModel wanted;
  FitSettings settings;
  Model model;  // without coefficients
  ReadOptions reading;
};

FitPlan plan_fit(const Arguments& arguments) {
  FitPlan plan;
  plan.wanted = wanted_model(arguments);
  FitSettings& settings = plan.settings;
  settings.identify.run_offsets = arguments.has("run-offsets");
  settings.row_denoising = row_denoising(arguments);
  settings.network = plan.wanted.network;
  settings.force_network = plan.wanted.network_is_the_model || arguments.has("force-network");
  settings.network_inputs = parse_network_inputs(arguments.text("inputs"));
  plan.model = model_settings(arguments, plan.wanted.effects);
  // Runs need these.
  if (plan.wanted.network.hidden > 0) plan.model.network.inputs = settings.network_inputs;
  // Here the scale factor is the board's too: it counts for recordings in deg/h as well.
  plan.reading = read_options(arguments);
  plan.model.scale_factor = plan.reading.scale_factor.value_or(kDefaultScaleFactor);
  std::swap(plan.reading.scale_factor, plan.reading.model_scale_factor);
  return plan;
}

}  // namespace

std::vector<Option> fit_options() {
  std::vector<std::string> row_rules = threshold_rule_names();
  row_rules.emplace_back("none");
  std::vector<Option> options{
      {"effects", "LIST", "NAME,NAME:p=VALUE,...; ? for a value: identified", "", false,
       effect_names()},
      {"effect-expr", "EXPR", "a term of your own: 'late = lag(T,?tau[60,900]) - T'", "", true},
      {"model", "NAME", "instead of --effects, --network; a board runs each: " + fit_model_list(),
       "", false, fit_model_names()},
      {"average", "S", "rows of the fit, seconds", "10"},
      {"run-offsets", "", "a bias for each recording; the model keeps the first", ""},
  };
  for (Option& option : training_options()) options.push_back(std::move(option));
  for (Option& option : rarely({
           {"inputs", "LIST", "of the network: also lagged_temperature:tau=S, elapsed, supply, ...",
            "temperature,temperature_rate", false, network_input_names()},
           {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30"},
           {"wavelet", "NAME", "of the board's denoiser", "sym8", false, wavelet_names()},
           {"levels", "N", "of the board's denoiser, 0 for none", "5"},
           {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
            "heursure", false, kBoardRules},
           {"mode", "NAME", "soft or hard thresholds", "soft", false, {"soft", "hard"}},
           {"denoise-rows", "RULE", "denoise what the network is trained on, by heursure, ...",
            "none", false, row_rules},
       })) {
    options.push_back(std::move(option));
  }
  return options;
}

void check_fit_options(const Arguments& arguments) {
  plan_fit(arguments);
}

Fit fit_recordings(const Arguments& arguments, const std::vector<std::string>& files,
                   OnInterrupt on_interrupt) {
  auto [wanted, settings, wanted_terms, reading] = plan_fit(arguments);
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
  model.history.push_back({"fit " + fitted(arguments, wanted.effects), training.data_hash,
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
