#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "support/output_file.hpp"

namespace fogcomp::recording {

/// A path in a folder of this process alone, removed at its end: tests may run side by side.
inline std::string temporary_path(const std::string& name) {
  struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("fogcomp_test_" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
  };
  static const Folder folder;
  return (folder.path / name).string();
}

/// Writes `content` to temporary_path(name), which it returns.
inline std::string temporary_file(const std::string& name, std::string_view content) {
  const std::string path = temporary_path(name);
  write_file(path, content);
  return path;
}

}  // namespace fogcomp::recording
