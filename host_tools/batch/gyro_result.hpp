#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fogcomp::batch {

/// Result of one gyro: values, or the reason why there are none. The verdict is not included,
/// because limits may change without a new fit.
struct GyroResult {
  std::string gyro;
  std::string fingerprint;  ///< of recordings and options
  std::string error;        ///< one line; "" if there are values
  std::vector<std::pair<std::string, double>> figures;
  std::vector<std::string> notes{};  ///< remarks, one sentence each
  /// Files written with it: name and fingerprint.
  std::vector<std::pair<std::string, std::string>> outputs{};

  std::optional<double> figure(const std::string& name) const;
};

/// The file of a gyro's result in `folder`.
std::string result_path(const std::string& folder);

/// Adds the present file `name` of `folder` to the outputs.
void add_output(GyroResult& result, const std::string& folder, const std::string& name);

/// Whether every output in `folder` is unchanged.
bool outputs_are_whole(const GyroResult& result, const std::string& folder);

/// Writes result_path(), completely or not at all. Throws InputError if the folder is not writable.
void save_result(const GyroResult& result, const std::string& folder);

/// Nothing if there is no result that this version can read: it is computed again.
std::optional<GyroResult> load_result(const std::string& gyro, const std::string& folder);

/// A limit of a value: "holdout_drift_dph <= 0.01".
struct Limit {
  std::string figure;
  bool is_max = true;  ///< else a lower limit
  double value = 0;

  bool meets(double figure_value) const {
    return is_max ? figure_value <= value : figure_value >= value;
  }
};

/// Parses a limits file: one `FIGURE <= NUMBER` or `FIGURE >= NUMBER` per line, `#` comments.
/// Throws InputError with file and line; for a name that is not in `known`, with the nearest one.
std::vector<Limit> parse_limits(const std::string& text, const std::string& file,
                                const std::vector<std::string>& known);

/// The limits that a gyro violates, as text, separated by "; "; "" if none. A missing value
/// violates its limit.
std::string broken_limits(const GyroResult& result, const std::vector<Limit>& limits);

/// Diagnosis of a gyro's model on its recordings.
struct GyroDiagnosis {
  std::string fingerprint;  ///< of the result that it belongs to
  std::string verdict;      ///< "none", "missing_effect", "ambiguous", "unknown"; "": failed
  std::vector<std::string> effects;  ///< missing together, or one of them
  double size_dph = 0;               ///< rms of the missing part
  std::optional<double> probability;
  std::string sentence;
  std::string next;  ///< command line; "": none
};

/// Writes diagnosis.txt in `folder`, completely or not at all. Throws InputError if that fails.
void save_diagnosis(const GyroDiagnosis& diagnosis, const std::string& folder);

/// Nothing if there is no diagnosis of that result.
std::optional<GyroDiagnosis> load_diagnosis(const std::string& folder,
                                            const std::string& fingerprint);

}  // namespace fogcomp::batch
