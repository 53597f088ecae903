#pragma once

#include <string>
#include <vector>

#include "batch/gyro_folders.hpp"
#include "batch/gyro_result.hpp"
#include "cli/arguments.hpp"

namespace fogcomp::cli {

/// The options that decide a gyro's result: those of fit, of recordings and of boards.
std::vector<Option> calibration_options();

/// Of the gyro's recordings, calibration_options() and the version of this tool. Throws InputError
/// for a recording that cannot be read.
std::string fingerprint_of(const batch::GyroFolder& gyro, const Arguments& arguments);

/// Throws InputError for options that no gyro can be calibrated with.
void check_calibration_options(const Arguments& arguments);

/// Every figure that a gyro can have with these options, for limits.
std::vector<std::string> figure_names(const Arguments& arguments);

/// fit, compare on the hold-outs, export: model, header and, with --reports, report.html in
/// `folder`. Returns the figures. Throws InputError as those commands do.
batch::GyroResult calibrate(const batch::GyroFolder& gyro, const Arguments& arguments,
                            const std::string& folder);

}  // namespace fogcomp::cli
