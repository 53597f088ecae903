#include "batch/gyro_folders.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include "support/input_error.hpp"
#include "support/output_file.hpp"

namespace fogcomp::batch {
namespace {

namespace fs = std::filesystem;

bool matches(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0;
}

GyroFolder read_folder(const fs::path& folder, const FilePatterns& patterns) {
  require_printable_name(folder.string());
  const std::string parent = folder.parent_path().string();
  GyroFolder gyro{parent.empty() ? "." : parent, folder.filename().string(), {}, {}};
  std::error_code unreadable;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() || !matches(patterns.runs, name)) continue;
    require_printable_name(entry.path().string());
    (matches(patterns.holdouts, name) ? gyro.holdouts : gyro.recordings)
        .push_back(entry.path().string());
  }
  std::sort(gyro.recordings.begin(), gyro.recordings.end());
  std::sort(gyro.holdouts.begin(), gyro.holdouts.end());
  return gyro;
}

}  // namespace

GyroFolder find_gyro(const std::string& folder, const FilePatterns& patterns) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(folder, "is no folder; name the one with the gyro's recordings");
  }
  fs::path path = fs::path(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "gyros/G001/"
  const fs::path name = path.filename();
  return read_folder(name == "." || name == ".." ? fs::canonical(path) : path, patterns);
}

std::vector<GyroFolder> find_gyros(const std::string& parent, const FilePatterns& patterns) {
  std::error_code error;
  fs::directory_iterator entries(parent, error);
  if (error) {
    throw InputError(parent, "cannot be read (" + error.message() +
                                 "); name the folder that has a folder per gyro");
  }
  std::vector<GyroFolder> gyros;
  for (const fs::directory_entry& entry : entries) {
    const bool hidden = entry.path().filename().string().front() == '.';
    if (!entry.is_directory() || hidden) continue;
    gyros.push_back(read_folder(entry.path(), patterns));
  }
  if (gyros.empty()) {
    throw InputError(parent,
                     "has no folder in it; give every gyro one, named by its serial number");
  }
  std::sort(gyros.begin(), gyros.end(),
            [](const GyroFolder& a, const GyroFolder& b) { return a.name < b.name; });
  return gyros;
}

}  // namespace fogcomp::batch
