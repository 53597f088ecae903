#include "workflow/calibrate.hpp"

#include <algorithm>
#include <cmath>

#include "fit/turn_on_bias.hpp"
#include "model/catalogue.hpp"
#include "runs/runs.hpp"
#include "support/units.hpp"
#include "workflow/diagnose.hpp"
#include "workflow/fit.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {
namespace {

using Figures = std::vector<std::pair<std::string, double>>;

// A value of each hold-out; the worst one counts.
struct HoldOutFigure {
  const char* name;
  std::optional<double> (*value)(const compare::Comparison&);
};

const HoldOutFigure kHoldOutFigures[] = {
    {"holdout_raw_std_dph",
     [](const compare::Comparison& run) { return std::optional(run.whole.raw_std_dph); }},
    {"holdout_rms_dph",
     [](const compare::Comparison& run) { return std::optional(run.whole.rms_dph); }},
    {"holdout_floor_dph", [](const compare::Comparison& run) { return run.noise_floor_dph; }},
    {"holdout_drift_dph",
     [](const compare::Comparison& run) -> std::optional<double> {
       if (!run.noise_floor_dph) return std::nullopt;
       return compare::floor_removed(run.whole.rms_dph, *run.noise_floor_dph);
     }},
    {"holdout_offset_dph",
     [](const compare::Comparison& run) { return std::optional(std::fabs(run.whole.mean_dph)); }},
    {"holdout_outliers",
     [](const compare::Comparison& run) {
       return std::optional(static_cast<double>(run.outliers));
     }},
    {"holdout_outside",
     [](const compare::Comparison& run) { return std::optional(run.outside.temperature); }},
};

Figures fit_figures(const FitOutcome& fit) {
  const model::Model& model = fit.model;
  Figures figures;
  figures.emplace_back("rows", static_cast<double>(fit.rows));
  figures.emplace_back("noise_dprh", model.noise_dph_rthz / std::sqrt(kSecondsPerHour));
  figures.emplace_back("fit_raw_std_dph", fit.result.raw_std_dph);
  figures.emplace_back("fit_rms_dph", model.residual_rms_dph);
  if (const auto floor = model.history.back().noise_floor_dph) {
    figures.emplace_back("fit_floor_dph", *floor);
    figures.emplace_back("fit_drift_dph", compare::floor_removed(model.residual_rms_dph, *floor));
  }
  figures.emplace_back("fit_misfit", fit.result.identified.birge_ratio);
  figures.emplace_back("fit_outliers", static_cast<double>(fit.result.identified.outliers));
  figures.emplace_back("network_hidden", static_cast<double>(model.network.hidden.biases.size()));
  return figures;
}

Figures hold_out_figures(const compare::ModelOnRuns& hold_outs) {
  Figures figures;
  for (const HoldOutFigure& figure : kHoldOutFigures) {
    std::optional<double> worst;
    for (const compare::ModelOnRun& run : hold_outs.runs) {
      const auto value = figure.value(run.comparison);
      if (value) worst = std::max(worst.value_or(*value), *value);
    }
    if (worst) figures.emplace_back(figure.name, *worst);
  }
  return figures;
}

// Values to be monitored from gyro to gyro: "temperature_rate.K", in the catalogue's units.
Figures coefficients_of(const model::Model& model) {
  Figures figures;
  for (const model::EffectTerm& term : model.terms) {
    const model::TermInfo info = model::info_of(term);
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      figures.emplace_back(term.name + "." + info.parameters[i].name, term.parameters[i].value);
    }
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      figures.emplace_back(term.name + "." + info.coefficients[i].symbol,
                           model::natural_coefficient(term, i).value);
    }
  }
  return figures;
}

Figures board_figures(const ExportOutcome& board) {
  Figures figures{{"quantization_error_dph", board.quantization.worst_dph}};
  if (board.network.points > 0) {
    figures.emplace_back("network_error_dph", board.network.worst_dph);
  }
  return figures;
}

std::vector<runs::Run> read_hold_outs(const CalibrationRequest& request, const FitOutcome& fit,
                                      const Observer& observer) {
  runs::Runs read =
      runs::read_holdouts(request.hold_outs, reading_for(fit.model, request.fit.reading, observer),
                          {fit.model.average_s}, fit.runs);
  observer.say(read.notes);
  return std::move(read.holdouts);
}

// The largest certain difference between runs of this gyro.
Figures turn_on_figures(const std::vector<compare::TurnOnBias>& turn_on) {
  const auto largest = std::max_element(
      turn_on.begin(), turn_on.end(),
      [](const auto& a, const auto& b) { return std::fabs(a.above_dph) < std::fabs(b.above_dph); });
  if (largest == turn_on.end()) return {};
  return {{"turn_on_bias_dph", std::fabs(largest->above_dph)},
          {"turn_on_sigma_dph", largest->sigma_dph}};
}

}  // namespace

CalibrationOutcome calibrate(const CalibrationRequest& request, const CalibrationEvents& events,
                             const Observer& observer) {
  CalibrationOutcome outcome;
  outcome.fit = fit(request.fit, observer);
  const model::Model& model = outcome.fit.model;
  if (events.fitted) events.fitted(model);
  std::vector<runs::Run> runs = read_hold_outs(request, outcome.fit, observer);
  outcome.hold_outs = {request.model_file, model, {}};
  for (const runs::Run& run : runs)
    outcome.hold_outs.runs.push_back(compare::try_model(model, run, model.average_s));
  if (events.judged) events.judged(outcome.hold_outs);
  outcome.board = board_header(model, request.model_file, request.board, request.allow_error);
  runs.insert(runs.begin(), outcome.fit.runs.begin(), outcome.fit.runs.end());
  outcome.turn_on = fit::turn_on_biases(model, runs);
  for (const Figures& part : {fit_figures(outcome.fit), hold_out_figures(outcome.hold_outs),
                              turn_on_figures(outcome.turn_on.biases), board_figures(outcome.board),
                              coefficients_of(model)}) {
    outcome.figures.insert(outcome.figures.end(), part.begin(), part.end());
  }
  return outcome;
}

CalibrationDiagnosis diagnose(const CalibrationRequest& request, const Observer& observer) {
  DiagnoseRequest question;
  question.model = request.model_file;
  question.runs = request.fit.runs;
  question.reading = request.fit.reading;
  question.hold_outs = request.hold_outs;
  CalibrationDiagnosis found{diagnose(question, observer).ladder};
  const auto shows_nothing = [](const diagnosis::Ladder& ladder) {
    return ladder.first.verdict == diagnosis::Verdict::none;
  };
  if (!shows_nothing(found.ladder) || request.hold_outs.empty()) return found;
  question.runs = request.hold_outs;
  question.hold_outs.clear();
  diagnosis::Ladder on_holdouts = diagnose(question, observer).ladder;
  if (shows_nothing(on_holdouts)) return found;
  return {std::move(on_holdouts), true};
}

std::vector<std::string> figure_names(const std::vector<model::EffectTerm>& terms) {
  std::vector<std::string> names{"rows",
                                 "noise_dprh",
                                 "fit_raw_std_dph",
                                 "fit_rms_dph",
                                 "fit_floor_dph",
                                 "fit_drift_dph",
                                 "fit_misfit",
                                 "fit_outliers",
                                 "network_hidden",
                                 "turn_on_bias_dph",
                                 "turn_on_sigma_dph",
                                 "quantization_error_dph",
                                 "network_error_dph"};
  for (const HoldOutFigure& figure : kHoldOutFigures) names.emplace_back(figure.name);
  for (const model::EffectTerm& term : terms) {
    const model::TermInfo info = model::info_of(term);
    for (const auto& parameter : info.parameters) names.push_back(term.name + "." + parameter.name);
    for (const auto& coefficient : info.coefficients) {
      names.push_back(term.name + "." + coefficient.symbol);
    }
  }
  return names;
}

std::vector<std::string> compared_figures(const std::vector<model::EffectTerm>& terms) {
  std::vector<std::string> names{"noise_dprh",       "fit_raw_std_dph", "fit_rms_dph",
                                 "fit_floor_dph",    "fit_misfit",      "holdout_rms_dph",
                                 "holdout_floor_dph"};
  for (const model::EffectTerm& term : terms) {
    for (const auto& coefficient : model::info_of(term).coefficients) {
      names.push_back(term.name + "." + coefficient.symbol);
    }
  }
  return names;
}

}  // namespace fogcomp::workflow
