#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/ladder.hpp"
#include "workflow/export_header.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// Calibration of one gyro of a production line: fit, compare on hold-outs, export.
struct CalibrationRequest {
  FitRequest fit;
  std::vector<std::string> hold_outs;  ///< recordings for judging only
  board::BoardSettings board;
  bool allow_error = false;  ///< of the board's table (verify_board)
  std::string model_file;    ///< future path of the model, for the header and for errors
};

/// Intermediate results, available even if a later step fails. Either function may be empty.
struct CalibrationEvents {
  std::function<void(const model::Model&)> fitted{};
  std::function<void(const compare::ModelOnRuns&)> judged{};  ///< on the hold-outs
};

struct CalibrationOutcome {
  FitOutcome fit;
  compare::ModelOnRuns hold_outs;
  ExportOutcome board;
  /// Values to be monitored from gyro to gyro, by name.
  std::vector<std::pair<std::string, double>> figures;
  /// Of every run but the first: fitted runs, then hold-outs.
  compare::TurnOn turn_on;
};

/// Throws InputError like fit(), runs::read_holdouts() and export_header().
CalibrationOutcome calibrate(const CalibrationRequest& request,
                             const CalibrationEvents& events = {}, const Observer& observer = {});

/// What is missing in the model of a calibrated gyro.
struct CalibrationDiagnosis {
  diagnosis::Ladder ladder;
  bool on_holdouts = false;  ///< else on the fitted recordings
};
/// Diagnoses the model that calibrate() has made on its fitted recordings or, if these show nothing
/// and the hold-outs do, on the hold-outs. Throws InputError like diagnose().
CalibrationDiagnosis diagnose(const CalibrationRequest& request, const Observer& observer = {});

/// All values that a gyro can have with these effects, for limits.
std::vector<std::string> figure_names(const std::vector<model::EffectTerm>& terms);

/// Values by which gyros of a lot are compared: noise, residual and coefficients of the drift.
std::vector<std::string> compared_figures(const std::vector<model::EffectTerm>& terms);

}  // namespace fogcomp::workflow
