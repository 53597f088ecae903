#pragma once

#include <string>
#include <vector>

#include "batch/gyro_folders.hpp"
#include "batch/gyro_result.hpp"
#include "cli/board_options.hpp"
#include "cli/fit_recordings.hpp"

namespace fogcomp::cli {

/// The options that decide a gyro's result.
struct CalibrationOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  FitOptions fit{this};
  BoardOptions board{this};
  RecordingOptions recording{this};
};

/// Of the gyro's recordings, options and the version of this tool. Throws InputError
/// for a recording that cannot be read.
std::string fingerprint_of(const batch::GyroFolder& gyro, const CalibrationOptions& options);

/// Throws InputError for options that no gyro can be calibrated with.
void check_calibration_options(const CalibrationOptions& options);

/// Every figure that a gyro can have with these options, for limits.
std::vector<std::string> figure_names(const FitOptions& options);

/// fit, compare on the hold-outs, export: model, header and, with `page`, report.html in `folder`.
/// Returns the figures. Throws InputError as those commands do.
batch::GyroResult calibrate(const batch::GyroFolder& gyro, const CalibrationOptions& options,
                            const std::string& folder, bool page);

}  // namespace fogcomp::cli
