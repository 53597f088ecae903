// fogcomp fit: recordings -> model file.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/arguments.hpp"
#include "cli/recording_options.hpp"
#include "core/protocol/crc.hpp"
#include "dataset/recording.hpp"
#include "dataset/recording_writer.hpp"
#include "evaluation/white_noise.hpp"
#include "identification/design.hpp"
#include "identification/identify.hpp"
#include "model/model_file.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "training/levenberg_marquardt.hpp"
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

// The rows of a fit without their noise, as the reference paper does it. Rows further apart than
// one and a half times their length are not neighbours.
void denoise_rows(Design& design, double average_s, const DenoiseMethod& method,
                  const std::string& file) {
  std::vector<fog::Span<double>> parts;
  for (Eigen::Index row = 0; row < design.rows(); ++row) {
    const auto index = static_cast<std::size_t>(row);
    const bool gap = row == 0 || design.time_s[index] - design.time_s[index - 1] > 1.5 * average_s;
    if (gap) parts.push_back({design.drift_dph.data() + row, 0});
    ++parts.back().size;
  }
  denoise_parts(parts, method, file);
}

double weighted_std(const Design& design) {
  const double mean = design.drift_dph.dot(design.weights) / design.weights.sum();
  const Eigen::ArrayXd deviation = design.drift_dph.array() - mean;
  return std::sqrt((deviation.square() * design.weights.array()).sum() / design.weights.sum());
}

DenoiseMethod row_denoising(const Arguments& arguments) {
  DenoiseMethod method;
  method.wavelet = arguments.choice("wavelet", wavelet_names());
  method.levels = static_cast<int>(arguments.integer("levels", 1, 10));
  method.rule = threshold_rule(arguments.choice("denoise-rows", threshold_rule_names()));
  method.hard = arguments.choice("mode", {"soft", "hard"}) == "hard";
  return method;
}

Json terms_json(const Model& model) {
  Json terms = Json::array();
  for (const EffectTerm& term : model.terms) {
    terms.push(std::move(Json::object()
                             .set("effect", term.name)
                             .set("parameters", term.parameters)
                             .set("coefficients_dph", term.coefficients_dph)
                             .set("sigma_dph", term.sigma_dph)));
  }
  return terms;
}

int run_fit(const Arguments& arguments) {
  const std::string output = arguments.required("o");
  Model model;
  model.terms = parse_effects(arguments.required("effects"));
  model.average_s = arguments.number("average", 1e-3, 1e6);
  model.derivative_tau_s = arguments.number("derivative-tau", 1e-3, 1e5);
  model.denoise.wavelet = arguments.choice("wavelet", wavelet_names());
  model.denoise.levels = static_cast<int>(arguments.integer("levels", 0, 10));
  const std::string rule = arguments.choice("threshold", kBoardRules);
  model.denoise.rule = static_cast<fog::ThresholdRule>(
      std::find(kBoardRules.begin(), kBoardRules.end(), rule) - kBoardRules.begin());
  model.denoise.hard = arguments.choice("mode", {"soft", "hard"}) == "hard";
  arguments.choice("trainer", {"lm"});
  TrainingSettings training;
  training.hidden = static_cast<int>(arguments.integer("network", 0, 32));
  training.seed = static_cast<std::uint64_t>(arguments.integer("seed", 0, INT64_MAX));

  // Here the scale factor is the board's too: it counts for recordings in deg/h as well.
  ReadOptions reading = read_options(arguments);
  model.scale_factor = reading.scale_factor.value_or(kDefaultScaleFactor);
  std::swap(reading.scale_factor, reading.model_scale_factor);
  std::vector<Design> designs;
  std::uint32_t hash = fog::kCrc32Initial;
  double noise_variance = 0;
  for (const std::string& file : arguments.positionals()) {
    const Recording recording = read_recording(file, reading);
    hash = data_hash(recording, hash);
    noise_variance += std::pow(white_noise_dph_rthz(recording), 2);
    designs.push_back(make_design(model, make_blocks(recording)));
    if (arguments.text("denoise-rows") != "none") {
      const double row_s = std::max(model.average_s, recording.period_s);
      denoise_rows(designs.back(), row_s, row_denoising(arguments), file);
    }
  }
  model.noise_dph_rthz =
      std::sqrt(noise_variance / static_cast<double>(arguments.positionals().size()));
  const Design design = join(designs);
  const double raw_std = weighted_std(design);
  const Eigen::VectorXd residual = identify(model, design);
  model.history.push_back(
      {"fit " + arguments.text("effects"), hash, raw_std, model.residual_rms_dph});

  double gamma = 0;
  if (training.hidden > 0) {
    const TrainingResult trained =
        train_levenberg_marquardt(design.signals, residual, design.weights, training);
    model.network = trained.network;
    model.residual_rms_dph = trained.rms_after_dph;
    gamma = trained.effective_parameters;
    model.history.push_back({format("network %d", training.hidden), hash, trained.rms_before_dph,
                             trained.rms_after_dph});
  }
  save_model(model, output);

  if (arguments.has("json")) {
    Json result = Json::object();
    result.set("model", output).set("rows", static_cast<std::size_t>(design.rows()));
    result.set("raw_std_dph", raw_std).set("residual_rms_dph", model.residual_rms_dph);
    result.set("effects", terms_json(model)).set("network_hidden", training.hidden);
    result.set("network_effective_parameters", gamma);
    std::puts(result.text().c_str());
    return 0;
  }
  std::printf("%td rows of %g s, raw std %.4f deg/h\n\n%s\n", design.rows(), model.average_s,
              raw_std, describe(model).c_str());
  for (const HistoryEntry& step : model.history) {
    std::printf("  %-44s %.4f -> %.4f deg/h rms\n", step.action.c_str(), step.rms_before_dph,
                step.rms_after_dph);
  }
  if (training.hidden > 0) {
    std::printf("  (of the network's weights the data determine %.1f)\n", gamma);
  }
  std::printf("\nwritten: %s\n", output.c_str());
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
      {"effects", "LIST", "a,b:parameter=value,c (fogcomp effects lists them)", ""},
      {"network", "N", "hidden neurons, 0 for none, at most 32", "0"},
      {"trainer", "NAME", "lm (Levenberg-Marquardt, Bayesian regularisation)", "lm"},
      {"seed", "N", "of the network's first weights", "1"},
      {"average", "S", "rows of the fit, seconds", "10"},
      {"derivative-tau", "S", "time constant of the two lags behind dT/dt", "30"},
      {"wavelet", "NAME", "of the board's denoiser", "sym8"},
      {"levels", "N", "of the board's denoiser, 0 for none", "5"},
      {"threshold", "RULE", "of the board: heursure and sqtwolog follow the noise; or fixed",
       "heursure"},
      {"mode", "NAME", "soft or hard thresholds", "soft"},
      {"denoise-rows", "RULE", "denoise the rows first, by heursure, sqtwolog, ...", "none"},
      {"json", "", "one JSON object on stdout", ""},
  };
  for (Option& option : recording_options()) command.options.push_back(std::move(option));
  command.run = run_fit;
  return command;
}

}  // namespace fogcomp::cli
