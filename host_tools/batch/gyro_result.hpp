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

}  // namespace fogcomp::batch
