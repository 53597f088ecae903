#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "workflow/export_header.hpp"
#include "workflow/fit.hpp"

namespace fogcomp::workflow {

/// One gyro of a production line: fit, compare on hold-outs, export.
struct CalibrationRequest {
  FitRequest fit;
  std::vector<std::string> hold_outs;  ///< recordings to judge by: the fit never sees them
  board::BoardSettings board;
  std::string model_file;  ///< where the model will be, for the header and for errors
};

/// What is known before the end, to be kept whatever a later step refuses. Either may be empty.
struct CalibrationEvents {
  std::function<void(const model::Model&)> fitted{};
  std::function<void(const compare::ModelOnRuns&)> judged{};  ///< on the hold-outs
};

struct CalibrationOutcome {
  FitOutcome fit;
  compare::ModelOnRuns hold_outs;
  ExportOutcome board;
  /// What a line watches from gyro to gyro, by name.
  std::vector<std::pair<std::string, double>> figures;
  /// Of every run but the first, those to fit to and then the hold-outs.
  std::vector<compare::TurnOnBias> turn_on;
};

/// Throws InputError as fit(), read_holdouts() and export_header() do.
CalibrationOutcome calibrate(const CalibrationRequest& request,
                             const CalibrationEvents& events = {}, const Observer& observer = {});

/// Every figure that a gyro can have with such a fit, for limits. Throws InputError as check() does
/// for its effects.
std::vector<std::string> figure_names(const FitRequest& fit);

/// Those by which gyros of a lot are compared: noise, residual and the coefficients of the drift.
std::vector<std::string> compared_figures(const FitRequest& fit);

}  // namespace fogcomp::workflow
