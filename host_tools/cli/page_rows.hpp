#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::cli {

/// Largest recording that goes into a page as it is, bytes: some 100,000 rows.
constexpr std::size_t kMaxPageFile = 4'000'000;

/// A recording as a page carries it where one is larger: its means over 1 s, the blocks in which a
/// board takes them, as a CSV of the plain format.
struct PageRows {
  std::string csv;
  std::size_t samples = 0;  ///< of the recording
  std::size_t rows = 0;     ///< that are left of them
};

/// Throws InputError as read_recording() does.
PageRows page_rows(const std::string& path, const recording::ReadOptions& options);

}  // namespace fogcomp::cli
