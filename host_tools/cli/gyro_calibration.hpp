#pragma once

#include <string>
#include <vector>

#include "batch/gyro_folders.hpp"
#include "batch/gyro_result.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "cli/recording_options.hpp"
#include "workflow/calibrate.hpp"

namespace fogcomp::cli {

/// The options that influence a gyro's result.
struct CalibrationOptions : OptionGroup {
  using OptionGroup::OptionGroup;

  FitOptions fit{this};
  Text prior_lot{this,
                 {"prior-lot", "FILE", "what sisters teach (batch --lot), without this gyro"}};
  BoardOptions board{this};
  AllowErrorFlag allow_error{this, "a board's table even if the model is uncertain, or not exact"};
  RecordingOptions recording{this};
};

/// The options of `calibrate`, which `batch` hands on to it.
struct LotOptions : OptionGroup {
  explicit LotOptions(OptionGroup* parent);
  std::vector<Command::Need> needs() const;
  batch::FilePatterns patterns() const { return {runs.value(), holdouts.value()}; }

  Text output{this, {"o", "OUT", "results: a folder a gyro; gyros.csv, index.html"}};
  Text runs{this, {"runs", "PATTERN", "recordings in DIR/SERIAL/", "*.csv"}};
  Text holdouts{this,
                {"holdouts", "PATTERN", "those of them that judge, unseen by the fit", "holdout*"}};
  Text limits{this, {"limits", "FILE", "lines such as holdout_drift_dph <= 0.01"}};
  Flag reports{this, "reports", "a page of plots for every gyro too (needs hold-outs)"};
  CalibrationOptions calibration{this};
};

/// Calibrates gyros, one at a time: what their results follow from, and what is there already. A
/// gyro's results are files in the folder OUT/SERIAL.
class GyroCalibration {
 public:
  /// Throws InputError for options with which no gyro can be calibrated, limits that no gyro can
  /// have, and results among the recordings in `gyros`.
  GyroCalibration(const LotOptions& options, const std::string& gyros);

  const workflow::FitRequest& fit() const { return request_.fit; }
  const std::vector<model::EffectTerm>& terms() const { return terms_; }
  const std::vector<batch::Limit>& limits() const { return limits_; }
  std::string folder_of(const batch::GyroFolder& gyro) const;

  /// The result for these recordings and options, if its files are unchanged. After an error there
  /// is none: a full disk or a killed process says nothing about the gyro. Throws InputError for an
  /// unreadable recording.
  std::optional<batch::GyroResult> result_of(const batch::GyroFolder& gyro) const;
  /// The diagnosis of this result.
  std::optional<batch::GyroDiagnosis> diagnosis_of(const batch::GyroFolder& gyro,
                                                   const batch::GyroResult& result) const;
  /// Whether the result violates a limit, and nobody has said why.
  bool lacks_diagnosis(const batch::GyroFolder& gyro, const batch::GyroResult& result) const;

  /// Removes the results of earlier runs, and writes model, header, result.txt and, if asked for,
  /// report.html, or why there is no result. Throws InputError if the folder is not writable.
  batch::GyroResult calibrate(const batch::GyroFolder& gyro) const;
  /// Writes what is missing in the model. The proposed command never fits a hold-out. Throws
  /// InputError if the folder is not writable.
  void diagnose(const batch::GyroFolder& gyro, const batch::GyroResult& result) const;

 private:
  std::string fingerprint_of(const batch::GyroFolder& gyro) const;
  std::string diagnosis_fingerprint(const batch::GyroFolder& gyro,
                                    const batch::GyroResult& result) const;
  workflow::CalibrationRequest request_for(const batch::GyroFolder& gyro) const;
  batch::GyroResult calibrated(const batch::GyroFolder& gyro) const;
  batch::GyroDiagnosis diagnosed(const batch::GyroFolder& gyro) const;

  const LotOptions& options_;
  workflow::CalibrationRequest request_;
  std::vector<model::EffectTerm> terms_;
  std::vector<batch::Limit> limits_;
};

}  // namespace fogcomp::cli
