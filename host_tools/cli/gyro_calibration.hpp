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

/// The options that decide a gyro's result.
struct CalibrationOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// Without a gyro's recordings. Throws InputError for options that no gyro can be calibrated
  /// with.
  workflow::CalibrationRequest request() const;
  /// Of a gyro's recordings, these options and the version of this tool. Throws InputError for a
  /// recording that cannot be read.
  std::string fingerprint_of(const batch::GyroFolder& gyro) const;

  FitOptions fit{this};
  BoardOptions board{this};
  RecordingOptions recording{this};
};

/// Calibrates a gyro as `request` says: model, header and, with `page`, report.html in `folder`.
/// Returns the figures. Throws InputError as workflow::calibrate() does.
batch::GyroResult calibrate(const batch::GyroFolder& gyro, workflow::CalibrationRequest request,
                            const std::string& folder, bool page);

/// What the model in `folder` lacks, by the recordings that it was fitted to; where these show
/// nothing, by the hold-outs. What is proposed next is never fitted to a hold-out. `reading`: the
/// options of reading as they were given. Throws InputError as workflow::diagnose() does.
batch::GyroDiagnosis diagnose(const batch::GyroFolder& gyro,
                              const workflow::CalibrationRequest& request,
                              const std::string& folder, const std::vector<std::string>& reading);

}  // namespace fogcomp::cli
