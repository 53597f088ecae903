// fogcomp fit: recordings -> model file.

#include <algorithm>
#include <cstdio>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/fit_models.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/training_options.hpp"
#include "dataset/recording_writer.hpp"
#include "identification/effect_list.hpp"
#include "model/model_file.hpp"
#include "refinement/fit_model.hpp"
#include "refinement/network_inputs.hpp"
#include "refinement/training_runs.hpp"
#include "report/fit_report.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "wavelet/filters.hpp"

namespace fogcomp::cli {
namespace {

// Nothing where the rows are to stay as they are.
std::optional<DenoiseMethod> row_denoising(const Arguments& arguments) {
  std::vector<std::string> rules = threshold_rule_names();
  rules.emplace_back("none");
  const std::string rule = arguments.choice("denoise-rows", rules);
  if (rule == "none") return std::nullopt;
  DenoiseMethod method;
  method.wavelet = arguments.choice("wavelet", wavelet_names());
  method.levels = static_cast<int>(arguments.integer("levels", 1, 10));
  method.rule = threshold_rule(rule);
  method.hard = arguments.choice("mode", {"soft", "hard"}) == "hard";
  return method;
}

Json terms_json(const Model& model) {
  Json terms = Json::array();
  for (const EffectTerm& term : model.terms) {
    terms.push(std::move(Json::object()
                             .set("effect", term.name)
                             .set("parameters", term.parameters)
                             .set("parameter_sigma", term.parameter_sigma)
                             .set("coefficients_dph", term.coefficients_dph)
                             .set("sigma_dph", term.sigma_dph)));
  }
  return terms;
}

struct Fit {
  Model model;
  Eigen::Index rows = 0;
  double row_s = 0;
  std::vector<RunInBlocks> runs;
  FitResult result;
  double delay_rms_dph = 0;              // of the error, what the board's delay makes
  std::vector<std::string> step_places;  // of each step found: recording and segment
  bool searched_steps = false;
};

// The segment of a recording in which a time lies.
std::string segment_at(const RunInBlocks& run, double time_s) {
  for (const RunInBlocks::TimedSegment& segment : run.segments) {
    if (time_s < segment.end_s) return segment.name;
  }
  return "";
}

std::string steps_text(const Fit& fit) {
  const Identification& identified = fit.result.identified;
  std::string text;
  for (std::size_t i = 0; i < identified.steps.size(); ++i) {
    const FoundStep& step = identified.steps[i];
    text += format("  bias step of %+.4f +- %.2g deg/h at %.6g +- %.2g s (%s)\n", step.size_dph,
                   step.size_sigma_dph, step.time_s, step.time_sigma_s, fit.step_places[i].c_str());
  }
  if (identified.masked > 0) {
    text += format("  %zu rows in which a step lies were left out\n", identified.masked);
  }
  if (fit.searched_steps && identified.steps.empty()) {
    text += "  no bias step stands out of the noise (chi^2 above 60)\n";
  }
  return text;
}

std::string identification_text(const Fit& fit) {
  const Model& model = fit.model;
  const Identification& identified = fit.result.identified;
  const NoiseModel& noise = identified.noise;
  std::string text = format("  noise of a row %.4f white", noise.white_dph());
  if (!noise.components.empty()) text += format(", %.4f slow", noise.wander_dph());
  text += format(" deg/h (%s); misfit %.2f",
                 noise.from_quiet_parts ? "from the soaks" : "from neighbouring rows: no soak",
                 identified.misfit);
  if (identified.outliers > 0) {
    text += format("; %zu outliers weighted down", identified.outliers);
  }
  text += format(
      "\n  of the error, the board's delay (block means, derivative filter) makes %.2g deg/h rms\n",
      fit.delay_rms_dph);
  text += steps_text(fit);
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    text += format("  %-24s would show from a peak of %.2g deg/h on\n", model.terms[i].name.c_str(),
                   identified.visible_dph[i]);
  }
  for (std::size_t run = 0; run < identified.run_offsets_dph.size(); ++run) {
    text += format("  recording %zu lies %+.4f deg/h from the first\n", run + 2,
                   identified.run_offsets_dph[run]);
  }
  for (const std::string& warning : identified.warnings) {
    text += format("  note: %s\n", warning.c_str());
  }
  return text;
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
  model.denoise.wavelet = arguments.choice("wavelet", wavelet_names());
  model.denoise.levels = static_cast<int>(arguments.integer("levels", 0, 10));
  const std::string rule = arguments.choice("threshold", kBoardRules);
  model.denoise.rule = static_cast<fog::ThresholdRule>(
      std::find(kBoardRules.begin(), kBoardRules.end(), rule) - kBoardRules.begin());
  model.denoise.hard = arguments.choice("mode", {"soft", "hard"}) == "hard";
  return model;
}

// A network was asked for, and there is none.
bool is_dropped(const Fit& fit) {
  return fit.result.training && !fit.model.network.present();
}

// Only lm knows.
std::optional<double> determined_weights(const Fit& fit) {
  if (!fit.model.network.present()) return std::nullopt;
  return fit.result.training->effective_parameters;
}

Fit fit(const Arguments& arguments) {
  const WantedModel wanted = wanted_model(arguments);
  FitSettings settings;
  settings.identify.run_offsets = arguments.has("run-offsets");
  settings.row_denoising = row_denoising(arguments);
  settings.network = wanted.network;
  settings.force_network = wanted.network_is_the_model || arguments.has("force-network");
  settings.network_inputs = parse_network_inputs(arguments.text("inputs"));

  Fit fit;
  Model& model = fit.model;
  model = model_settings(arguments, wanted.effects);
  if (wanted.network.hidden > 0) model.network.inputs = settings.network_inputs;  // runs need these
  fit.searched_steps = searches_steps(model.terms);
  // Here the scale factor is the board's too: it counts for recordings in deg/h as well.
  ReadOptions reading = read_options(arguments);
  model.scale_factor = reading.scale_factor.value_or(kDefaultScaleFactor);
  std::swap(reading.scale_factor, reading.model_scale_factor);
  TrainingRuns training = read_training_runs(arguments.positionals(), reading, model.average_s);
  model.noise_dph_rthz = training.noise_dph_rthz;
  SignalSeries series(model);
  for (const RunInBlocks& run : training.runs) series.add(run.blocks);
  fit.rows = series.rows().size();
  fit.row_s = series.rows().row_s;
  if (wanted.order_by_validation) choose_order(model.terms, series.rows());
  {
    TrainingWatch watch(settings.network.training);
    fit.result = fit_model(model, series, settings);
    if (fit.result.training) watch.report(*fit.result.training);
  }

  fit.delay_rms_dph = delay_error_dph(model, training.runs);
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

// On its own recordings as `compare` would judge it.
ModelOnRuns on_its_runs(const Fit& fit, const std::string& output) {
  ModelOnRuns model{output, fit.model, {}};
  for (const RunInBlocks& run : fit.runs) {
    Comparison comparison = compare_with(fit.model, run);
    ResidualAnalysis analysis = analyse_residual(comparison);
    model.runs.push_back({std::move(comparison), std::move(analysis)});
  }
  return model;
}

Json steps_json(const Fit& fit) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < fit.result.identified.steps.size(); ++i) {
    const FoundStep& step = fit.result.identified.steps[i];
    steps.push(std::move(Json::object()
                             .set("place", fit.step_places[i])
                             .set("time_s", step.time_s)
                             .set("time_sigma_s", step.time_sigma_s)
                             .set("size_dph", step.size_dph)
                             .set("size_sigma_dph", step.size_sigma_dph)));
  }
  return steps;
}

void print_json(const Fit& fit, const std::string& output) {
  const Identification& identified = fit.result.identified;
  Json notes = Json::array();
  for (const std::string& warning : identified.warnings) notes.push(warning);
  if (is_dropped(fit)) notes.push(network_verdict(fit.result));
  Json result = Json::object();
  result.set("model", output).set("rows", static_cast<std::size_t>(fit.rows));
  result.set("raw_std_dph", fit.result.raw_std_dph)
      .set("residual_rms_dph", fit.model.residual_rms_dph);
  result.set("misfit", identified.misfit).set("outliers", identified.outliers);
  result.set("noise_white_dph", identified.noise.white_dph());
  result.set("noise_slow_dph", identified.noise.wander_dph());
  result.set("run_offsets_dph", identified.run_offsets_dph).set("notes", std::move(notes));
  result.set("delay_rms_dph", fit.delay_rms_dph);
  result.set("steps", steps_json(fit)).set("masked_rows", identified.masked);
  result.set("effects", terms_json(fit.model));
  result.set("network_hidden", static_cast<int>(fit.model.network.hidden.biases.size()));
  const std::optional<double> determined = determined_weights(fit);
  result.set("network_effective_parameters", determined ? Json(*determined) : Json());
  const std::optional<OutOfSample>& judged = fit.result.network_judged;
  result.set("network_gain", judged ? Json(judged->gain) : Json());
  std::puts(result.text().c_str());
}

void print_text(const Fit& fit, const std::string& output) {
  std::printf("%td rows of %g s, raw std %.4f deg/h\n\n%s\n", fit.rows, fit.row_s,
              fit.result.raw_std_dph, describe(fit.model).c_str());
  std::puts(identification_text(fit).c_str());
  for (const HistoryEntry& step : fit.model.history) {
    std::printf("  %-44s %.4f -> %.4f deg/h rms\n", step.action.c_str(), step.rms_before_dph,
                step.rms_after_dph);
  }
  if (const std::optional<double> determined = determined_weights(fit)) {
    std::printf("  (of the network's weights the data determine %.1f)\n", *determined);
  }
  if (fit.result.network_judged) {
    std::printf("%s%s\n", network_verdict(fit.result).c_str(),
                is_dropped(fit) ? "; --force-network keeps it" : "");
  }
  std::printf("\nwritten: %s\n", output.c_str());
}

int run_fit(const Arguments& arguments) {
  const std::string output = arguments.required("o");
  ReportFile page(arguments);
  const Fit result = fit(arguments);
  save_model(result.model, output);
  if (page.wanted()) {
    page.write(report::fit_report(on_its_runs(result, output), result.result,
                                  identification_text(result)));
  }
  if (arguments.has("json")) {
    print_json(result, output);
  } else {
    print_text(result, output);
  }
  return 0;
}

}  // namespace

Command fit_command() {
  Command command;
  command.name = "fit";
  command.positionals = "RUN...";
  command.least_positionals = 1;
  command.most_positionals = kAnyNumber;
  command.summary = "identifies the effects, then trains the network on what they leave";
  command.example =
      "fogcomp fit run.csv -o gyro.model --effects bias,bias_temperature:order=2,temperature_rate "
      "--network 6";
  command.options = {
      {"o", "MODEL", "model file to write", ""},
      {"model", "NAME", fit_model_help(), ""},
      {"effects", "LIST", "a,b:p=value,c:p=?[1,9] (? identifies p; fogcomp effects lists them)",
       ""},
      {"effect-expr", "NAME = EXPRESSION",
       "a term of your own, e.g. 'burst = T*T*dTdt' or 'late = lag(T,?tau[60,900]) - T'", "", true},
      {"inputs", "LIST", "of the network: also lagged_temperature:tau=S, elapsed, input_rate",
       "temperature,temperature_rate"},
      {"average", "S", "rows of the fit, seconds", "10"},
      {"run-offsets", "", "every recording has a bias of its own; the model keeps the first's", ""},
      {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30"},
      {"wavelet", "NAME", "of the board's denoiser", "sym8"},
      {"levels", "N", "of the board's denoiser, 0 for none", "5"},
      {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
       "heursure"},
      {"mode", "NAME", "soft or hard thresholds", "soft"},
      {"denoise-rows", "RULE", "denoise what the network is trained on, by heursure, ...", "none"},
      report_option(),
      {"json", "", "one JSON object on stdout", ""},
  };
  for (Option& option : training_options()) command.options.push_back(std::move(option));
  add_recording_options(command);
  command.run = run_fit;
  return command;
}

}  // namespace fogcomp::cli
