#pragma once

#include <string>
#include <vector>

namespace fogcomp::batch {

/// One gyro of a production line: a folder named by its serial number.
struct GyroFolder {
  std::string parent;
  std::string name;
  std::vector<std::string> recordings;  ///< for the fit, by name
  std::vector<std::string> holdouts;    ///< for judging only
};

/// Shell patterns (fnmatch) for file names in a gyro's folder.
struct FilePatterns {
  std::string runs;      ///< recordings
  std::string holdouts;  ///< holdouts among them
};

/// One of them. Throws InputError if it is no folder, or has a control character in its name.
GyroFolder find_gyro(const std::string& folder, const FilePatterns& patterns);

/// The folders in `parent` by name, without hidden ones; includes those without a recording. Throws
/// InputError if `parent` cannot be read or has no folder.
std::vector<GyroFolder> find_gyros(const std::string& parent, const FilePatterns& patterns);

}  // namespace fogcomp::batch
