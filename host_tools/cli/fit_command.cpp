// fogcomp fit: recordings -> model file.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/fit_models.hpp"
#include "cli/recording_options.hpp"
#include "cli/training_options.hpp"
#include "core/protocol/crc.hpp"
#include "dataset/recording.hpp"
#include "dataset/recording_writer.hpp"
#include "evaluation/white_noise.hpp"
#include "identification/effect_list.hpp"
#include "identification/identify.hpp"
#include "identification/independent_rows.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "wavelet/denoise_parts.hpp"
#include "wavelet/filters.hpp"

namespace fogcomp::cli {
namespace {

// What a fit depends on, as one number for the model's history.
std::uint32_t data_hash(const Recording& recording, std::uint32_t crc) {
  const auto add = [&crc](const std::vector<double>& column) {
    crc = fog::crc32(reinterpret_cast<const std::uint8_t*>(column.data()),
                     column.size() * sizeof(double), crc);
  };
  add(recording.time_s);
  add(recording.temperature_degc);
  add(recording.rate_dph);
  add(recording.input_rate_dph);
  return crc;
}

double weighted_std(const Rows& rows) {
  const double mean = rows.drift_dph.dot(rows.weights) / rows.weights.sum();
  const Eigen::ArrayXd deviation = rows.drift_dph.array() - mean;
  return std::sqrt((deviation.square() * rows.weights.array()).sum() / rows.weights.sum());
}

// What the network is trained on, without its noise, as the reference paper does it. Rows further
// apart than one and a half times their length are not neighbours.
void denoise_rows(const Rows& rows, const DenoiseMethod& method, Eigen::VectorXd& values) {
  std::vector<fog::Span<double>> parts;
  std::size_t next_run = 0;
  for (std::size_t row = 0; row < rows.time_s.size(); ++row) {
    const bool new_run = next_run < rows.run_starts.size() && rows.run_starts[next_run] == row;
    if (new_run) ++next_run;
    if (new_run || rows.time_s[row] - rows.time_s[row - 1] > 1.5 * rows.row_s) {
      parts.push_back({values.data() + row, 0});
    }
    ++parts.back().size;
  }
  denoise_parts(parts, method, "--denoise-rows");
}

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

void print_identification(const Model& model, const Identification& identified) {
  const NoiseModel& noise = identified.noise;
  std::printf("  noise of a row %.4f white", noise.white_dph());
  if (!noise.components.empty()) std::printf(", %.4f slow", noise.wander_dph());
  std::printf(" deg/h (%s); misfit %.2f",
              noise.from_quiet_parts ? "from the soaks" : "from neighbouring rows: no soak",
              identified.misfit);
  if (identified.outliers > 0) std::printf("; %zu outliers weighted down", identified.outliers);
  std::puts("");
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    std::printf("  %-24s would show from a peak of %.2g deg/h on\n", model.terms[i].name.c_str(),
                identified.visible_dph[i]);
  }
  for (std::size_t run = 0; run < identified.run_offsets_dph.size(); ++run) {
    std::printf("  recording %zu lies %+.4f deg/h from the first\n", run + 2,
                identified.run_offsets_dph[run]);
  }
  for (const std::string& warning : identified.warnings) {
    std::printf("  note: %s\n", warning.c_str());
  }
  std::puts("");
}

// What the options ask for, as a model without coefficients.
Model model_settings(const Arguments& arguments, const std::string& effects) {
  Model model;
  model.terms = parse_effects(effects);
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

// Reads all recordings into `series`; sets what the model takes from them. Returns their hash.
std::uint32_t read_runs(const Arguments& arguments, Model& model, SignalSeries& series) {
  // Here the scale factor is the board's too: it counts for recordings in deg/h as well.
  ReadOptions reading = read_options(arguments);
  model.scale_factor = reading.scale_factor.value_or(kDefaultScaleFactor);
  std::swap(reading.scale_factor, reading.model_scale_factor);
  std::uint32_t hash = fog::kCrc32Initial;
  double noise_square = 0;
  for (const std::string& file : arguments.positionals()) {
    const Recording recording = read_recording(file, reading);
    hash = data_hash(recording, hash);
    noise_square += std::pow(white_noise_dph_rthz(recording), 2);
    series.add(make_blocks(recording));
  }
  model.noise_dph_rthz =
      std::sqrt(noise_square / static_cast<double>(arguments.positionals().size()));
  return hash;
}

// The network learns what the effects leave from temperature and temperature rate.
NetworkTask network_task(const Rows& rows, const Eigen::VectorXd& target) {
  NetworkTask task;
  task.inputs.resize(rows.size(), 2);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const auto& signals = rows.signals[static_cast<std::size_t>(i)];
    task.inputs.row(i) << signals.temperature, signals.temperature_rate;
  }
  task.target_dph = target;
  task.weights = rows.weights;
  task.run_starts = rows.run_starts;
  return task;
}

RealNetwork as_model(const TrainedNetwork& trained) {
  RealNetwork network;
  network.inputs = {
      {fog::NetworkInput::temperature, trained.inputs[0].centre, trained.inputs[0].half_range},
      {fog::NetworkInput::temperature_rate, trained.inputs[1].centre,
       trained.inputs[1].half_range}};
  network.hidden = trained.hidden;
  network.output = trained.output;
  network.centre_dph = trained.centre_dph;
  network.amplitude_dph = trained.amplitude_dph;
  return network;
}

struct Fit {
  Model model;
  Eigen::Index rows = 0;
  double row_s = 0;
  double raw_std_dph = 0;
  Identification identified;
  std::optional<double> effective_weights;  // of the network; lm knows
};

Fit fit(const Arguments& arguments) {
  const std::optional<DenoiseMethod> denoising = row_denoising(arguments);
  const FitModel wanted = fit_model(arguments);
  NetworkSettings training = wanted.network;

  Fit fit;
  Model& model = fit.model;
  model = model_settings(arguments, wanted.effects);
  SignalSeries series(model);
  const std::uint32_t hash = read_runs(arguments, model, series);
  const Rows& rows = series.rows();
  fit.rows = rows.size();
  fit.row_s = rows.row_s;
  fit.raw_std_dph = weighted_std(rows);
  if (wanted.order_by_validation) choose_order(model.terms, rows);
  fit.identified = identify(model, series, {arguments.has("run-offsets")});
  model.history.push_back({"fit " + wanted.effects, hash, fit.raw_std_dph, model.residual_rms_dph});
  if (training.hidden == 0) return fit;

  Eigen::VectorXd target = fit.identified.residual_dph;
  if (denoising) denoise_rows(rows, *denoising, target);
  training.training.independent_share = independent_share(fit.identified.noise);
  const TrainedNetwork trained = train_watched(network_task(rows, target), training);
  model.network = as_model(trained);
  model.residual_rms_dph = trained.rms_after_dph;
  model.history.push_back({format("network %d %s", training.hidden, training.trainer.c_str()), hash,
                           trained.rms_before_dph, trained.rms_after_dph});
  fit.effective_weights = trained.result.effective_parameters;
  return fit;
}

void print_json(const Fit& fit, const std::string& output) {
  const Identification& identified = fit.identified;
  Json notes = Json::array();
  for (const std::string& warning : identified.warnings) notes.push(warning);
  Json result = Json::object();
  result.set("model", output).set("rows", static_cast<std::size_t>(fit.rows));
  result.set("raw_std_dph", fit.raw_std_dph).set("residual_rms_dph", fit.model.residual_rms_dph);
  result.set("misfit", identified.misfit).set("outliers", identified.outliers);
  result.set("noise_white_dph", identified.noise.white_dph());
  result.set("noise_slow_dph", identified.noise.wander_dph());
  result.set("run_offsets_dph", identified.run_offsets_dph).set("notes", std::move(notes));
  result.set("effects", terms_json(fit.model));
  result.set("network_hidden", static_cast<int>(fit.model.network.hidden.biases.size()));
  result.set("network_effective_parameters",
             fit.effective_weights ? Json(*fit.effective_weights) : Json());
  std::puts(result.text().c_str());
}

void print_text(const Fit& fit, const std::string& output) {
  std::printf("%td rows of %g s, raw std %.4f deg/h\n\n%s\n", fit.rows, fit.row_s, fit.raw_std_dph,
              describe(fit.model).c_str());
  print_identification(fit.model, fit.identified);
  for (const HistoryEntry& step : fit.model.history) {
    std::printf("  %-44s %.4f -> %.4f deg/h rms\n", step.action.c_str(), step.rms_before_dph,
                step.rms_after_dph);
  }
  if (fit.effective_weights) {
    std::printf("  (of the network's weights the data determine %.1f)\n", *fit.effective_weights);
  }
  std::printf("\nwritten: %s\n", output.c_str());
}

int run_fit(const Arguments& arguments) {
  const std::string output = arguments.required("o");
  const Fit result = fit(arguments);
  save_model(result.model, output);
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
      {"effects", "LIST", "a,b:parameter=value,c (fogcomp effects lists them)", ""},
      {"average", "S", "rows of the fit, seconds", "10"},
      {"run-offsets", "", "every recording has a bias of its own; the model keeps the first's", ""},
      {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30"},
      {"wavelet", "NAME", "of the board's denoiser", "sym8"},
      {"levels", "N", "of the board's denoiser, 0 for none", "5"},
      {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
       "heursure"},
      {"mode", "NAME", "soft or hard thresholds", "soft"},
      {"denoise-rows", "RULE", "denoise what the network is trained on, by heursure, ...", "none"},
      {"json", "", "one JSON object on stdout", ""},
  };
  for (Option& option : training_options()) command.options.push_back(std::move(option));
  for (Option& option : recording_options()) command.options.push_back(std::move(option));
  command.run = run_fit;
  return command;
}

}  // namespace fogcomp::cli
