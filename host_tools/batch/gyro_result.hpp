#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fogcomp::batch {

/// What is known of one gyro: figures, or why there are none. Whether the figures are good enough
/// is not in it: limits may change without a fit anew.
struct GyroResult {
  std::string gyro;
  std::string fingerprint;  ///< of recordings and options
  std::string error;        ///< one line; "" where there are figures
  std::vector<std::pair<std::string, double>> figures;
  std::vector<std::string> notes{};  ///< what has to be known of it, a sentence each
  /// What was written beside it: name and fingerprint of each file.
  std::vector<std::pair<std::string, std::string>> outputs{};

  std::optional<double> figure(const std::string& name) const;
};

/// The file of a gyro's result in `folder`.
std::string result_path(const std::string& folder);

/// Adds the file `name` of `folder` to the outputs, as it is now.
void add_output(GyroResult& result, const std::string& folder, const std::string& name);

/// Whether every output is in `folder` as it was written.
bool outputs_are_whole(const GyroResult& result, const std::string& folder);

/// Writes result_path() whole or not at all. Throws InputError where the folder cannot be written.
void save_result(const GyroResult& result, const std::string& folder);

/// Nothing where there is no result, or none that this version can read: it is made again then.
std::optional<GyroResult> load_result(const std::string& gyro, const std::string& folder);

}  // namespace fogcomp::batch
