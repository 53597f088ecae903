#pragma once

#include <string>
#include <vector>

namespace fogcomp::batch {

/// One gyro of a production line: a folder named by its serial number.
struct GyroFolder {
  std::string name;
  std::vector<std::string> recordings;  ///< for the fit, by name
  std::vector<std::string> holdouts;    ///< for judging only
};

/// Shell patterns (fnmatch) for file names in a gyro's folder.
struct FilePatterns {
  std::string runs;      ///< recordings
  std::string holdouts;  ///< holdouts among them
};

/// The folders in `parent` by name, without hidden ones; includes those without a recording. Throws
/// InputError if `parent` cannot be read or has no folder.
std::vector<GyroFolder> find_gyros(const std::string& parent, const FilePatterns& patterns);

/// Part `index` (1 to `count`) of `count`: every count-th gyro.
std::vector<GyroFolder> shard_of(const std::vector<GyroFolder>& gyros, std::size_t index,
                                 std::size_t count);

}  // namespace fogcomp::batch
