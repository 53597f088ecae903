#pragma once

#include <string>

#include "batch/gyro_diagnosis.hpp"
#include "batch/gyro_folders.hpp"
#include "batch/gyro_result.hpp"
#include "cli/board_options.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "workflow/calibrate.hpp"

namespace fogcomp::cli {

/// The options that influence a gyro's result.
struct CalibrationOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// A request without recordings. Throws InputError for options with which no gyro can be
  /// calibrated.
  workflow::CalibrationRequest request() const;
  /// Fingerprint of a gyro's recordings, these options and the tool's version. Throws InputError
  /// for an unreadable recording.
  std::string fingerprint_of(const batch::GyroFolder& gyro) const;

  FitOptions fit{this};
  BoardOptions board{this};
  RecordingOptions recording{this};
};

/// Calibrates a gyro by `settings`: writes model, header and, with `page`, report.html to `folder`.
/// Returns the values. Throws InputError like workflow::calibrate().
batch::GyroResult calibrate(const batch::GyroFolder& gyro,
                            const workflow::CalibrationRequest& settings, const std::string& folder,
                            bool page);

/// Diagnoses the model in `folder`. The proposed command never fits a hold-out. `reading`: the
/// given reading options. Throws InputError like workflow::diagnose().
batch::GyroDiagnosis diagnose(const batch::GyroFolder& gyro,
                              const workflow::CalibrationRequest& settings,
                              const std::string& folder, const std::vector<std::string>& reading);

}  // namespace fogcomp::cli
