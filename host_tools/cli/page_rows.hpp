#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::cli {

/// Largest recording that is embedded in a page unchanged, bytes: about 100,000 rows.
constexpr std::size_t kMaxPageFile = 4'000'000;

/// A larger recording as embedded in a page: its means over 1 s, the board's blocks, as a CSV of
/// the plain format.
struct PageRows {
  std::string csv;
  std::size_t samples = 0;  ///< of the recording
  std::size_t rows = 0;     ///< that remain
};

/// Throws InputError like read_recording().
PageRows page_rows(const std::string& path, const recording::ReadOptions& options);

}  // namespace fogcomp::cli
