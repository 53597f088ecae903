#pragma once

#include <string>
#include <vector>

namespace fogcomp::batch {

/// One gyro of a production line: a folder that has its serial number for a name.
struct GyroFolder {
  std::string name;
  std::vector<std::string> recordings;  ///< to fit to, by name
  std::vector<std::string> holdouts;    ///< to judge by: the fit never sees them
};

/// Shell patterns (fnmatch) for file names in a gyro's folder.
struct FilePatterns {
  std::string runs;      ///< what is a recording
  std::string holdouts;  ///< which of those are to judge by
};

/// The folders in `parent` by name, hidden ones left out. One without a recording is listed too.
/// Throws InputError where `parent` cannot be read or has no folder.
std::vector<GyroFolder> find_gyros(const std::string& parent, const FilePatterns& patterns);

/// Part `index` of `count` (1 to count): every count-th gyro, so that the parts together are all.
std::vector<GyroFolder> shard_of(const std::vector<GyroFolder>& gyros, std::size_t index,
                                 std::size_t count);

}  // namespace fogcomp::batch
