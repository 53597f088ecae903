// One gyro of a batch: fit, compare, export, as those commands do them.

#include "cli/gyro_calibration.hpp"

#include <algorithm>
#include <cmath>

#include "batch/fingerprint.hpp"
#include "cli/board_header.hpp"
#include "cli/fit_models.hpp"
#include "cli/recording_options.hpp"
#include "compare/model_on_runs.hpp"
#include "fit/training_runs.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "report/compare_report.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/units.hpp"

namespace fogcomp::cli {
namespace {

using Figures = std::vector<std::pair<std::string, double>>;

// A figure of each hold-out; the worst counts.
struct HoldoutFigure {
  const char* name;
  std::optional<double> (*value)(const Comparison&);
};

const HoldoutFigure kHoldoutFigures[] = {
    {"holdout_raw_std_dph",
     [](const Comparison& run) { return std::optional(run.whole.raw_std_dph); }},
    {"holdout_rms_dph", [](const Comparison& run) { return std::optional(run.whole.rms_dph); }},
    {"holdout_floor_dph", [](const Comparison& run) { return run.noise_floor_dph; }},
    {"holdout_drift_dph",
     [](const Comparison& run) -> std::optional<double> {
       if (!run.noise_floor_dph) return std::nullopt;
       return floor_removed(run.whole.rms_dph, *run.noise_floor_dph);
     }},
    {"holdout_offset_dph",
     [](const Comparison& run) { return std::optional(std::fabs(run.whole.mean_dph)); }},
    {"holdout_outliers",
     [](const Comparison& run) { return std::optional(static_cast<double>(run.outliers)); }},
    {"holdout_outside",
     [](const Comparison& run) { return std::optional(run.outside.temperature); }},
};

void add_fit_figures(Figures& figures, const Fit& fit) {
  const Model& model = fit.model;
  figures.emplace_back("rows", static_cast<double>(fit.rows));
  figures.emplace_back("noise_dprh", model.noise_dph_rthz / std::sqrt(kSecondsPerHour));
  figures.emplace_back("fit_raw_std_dph", fit.result.raw_std_dph);
  figures.emplace_back("fit_rms_dph", model.residual_rms_dph);
  if (const auto floor = model.history.back().noise_floor_dph) {
    figures.emplace_back("fit_floor_dph", *floor);
    figures.emplace_back("fit_drift_dph", floor_removed(model.residual_rms_dph, *floor));
  }
  figures.emplace_back("fit_misfit", fit.result.identified.misfit);
  figures.emplace_back("fit_outliers", static_cast<double>(fit.result.identified.outliers));
  figures.emplace_back("network_hidden", static_cast<double>(model.network.hidden.biases.size()));
}

void add_holdout_figures(Figures& figures, const ModelOnRuns& holdouts) {
  for (const HoldoutFigure& figure : kHoldoutFigures) {
    std::optional<double> worst;
    for (const ModelOnRun& run : holdouts.runs) {
      const auto value = figure.value(run.comparison);
      if (value) worst = std::max(worst.value_or(*value), *value);
    }
    if (worst) figures.emplace_back(figure.name, *worst);
  }
}

// What a line watches from gyro to gyro: "temperature_rate.K", in the catalogue's units.
void add_coefficients(Figures& figures, const Model& model) {
  for (const EffectTerm& term : model.terms) {
    if (is_event(term)) continue;
    const TermInfo info = info_of(term);
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      figures.emplace_back(term.name + "." + info.parameters[i].name, term.parameters[i]);
    }
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      figures.emplace_back(term.name + "." + info.coefficients[i].symbol,
                           natural_coefficient(term, i));
    }
  }
}

ModelOnRuns on_holdouts(const batch::GyroFolder& gyro, const Fit& fit, const std::string& file,
                        const RecordingOptions& recording) {
  ReadOptions reading = recording.value();
  reading.model_scale_factor = fit.model.scale_factor;
  ModelOnRuns model{file, fit.model, {}};
  const Holdouts holdouts = read_holdouts(gyro.holdouts, reading, fit.model.average_s, fit.runs);
  print_notes(holdouts.notes);
  for (const RunInBlocks& run : holdouts.runs) {
    model.runs.push_back(try_model(fit.model, run));
  }
  return model;
}

}  // namespace

void check_calibration_options(const CalibrationOptions& options) {
  check_fit_options(options.fit, options.recording);
  options.board.value();
}

std::string fingerprint_of(const batch::GyroFolder& gyro, const CalibrationOptions& options) {
  batch::Fingerprint fingerprint;
  fingerprint.add(FOGCOMP_VERSION);
  for (const Option* option : options.options()) {
    fingerprint.add(option->name);
    fingerprint.add(option->given() ? "given" : "default");
    for (const std::string& value : option->values) fingerprint.add(value);
    fingerprint.add(option->default_value);
  }
  for (const std::string& file : gyro.recordings) fingerprint.add_file(file);
  fingerprint.add("hold-outs");
  for (const std::string& file : gyro.holdouts) fingerprint.add_file(file);
  return fingerprint.text();
}

std::vector<std::string> figure_names(const FitOptions& options) {
  std::vector<std::string> names{"rows",
                                 "noise_dprh",
                                 "fit_raw_std_dph",
                                 "fit_rms_dph",
                                 "fit_floor_dph",
                                 "fit_drift_dph",
                                 "fit_misfit",
                                 "fit_outliers",
                                 "network_hidden",
                                 "quantization_error_dph",
                                 "network_error_dph"};
  for (const HoldoutFigure& figure : kHoldoutFigures) names.emplace_back(figure.name);
  std::vector<EffectTerm> terms = parse_effects(wanted_model(options).effects);
  for (const std::string& definition : options.expressions.value()) {
    add_expression(terms, definition);
  }
  for (const EffectTerm& term : terms) {
    const TermInfo info = info_of(term);
    for (const auto& parameter : info.parameters) names.push_back(term.name + "." + parameter.name);
    for (const auto& coefficient : info.coefficients) {
      names.push_back(term.name + "." + coefficient.symbol);
    }
  }
  return names;
}

batch::GyroResult calibrate(const batch::GyroFolder& gyro, const CalibrationOptions& options,
                            const std::string& folder, bool page) {
  const std::string model_name = gyro.name + ".model";
  const std::string model_path = folder + "/" + model_name;
  batch::GyroResult result{gyro.name, "", "", {}};
  const Fit fit =
      fit_recordings(options.fit, options.recording, gyro.recordings, OnInterrupt::stop);
  save_model(fit.model, model_path);
  const ModelOnRuns holdouts = on_holdouts(gyro, fit, model_path, options.recording);
  add_fit_figures(result.figures, fit);
  add_holdout_figures(result.figures, holdouts);
  if (page && !holdouts.runs.empty()) {
    write_file(folder + "/report.html", report::compare_report({holdouts}).html());
    add_output(result, folder, "report.html");
  }
  const BoardHeader header = board_header(fit.model, model_path, options.board.value(), false);
  result.figures.emplace_back("quantization_error_dph", header.error.worst_dph);
  if (header.network.points > 0) {
    result.figures.emplace_back("network_error_dph", header.network.worst_dph);
  }
  add_coefficients(result.figures, fit.model);
  write_file(folder + "/fog_model.h", header.text);
  add_output(result, folder, model_name);
  add_output(result, folder, "fog_model.h");
  return result;
}

}  // namespace fogcomp::cli
