#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::cli {

/// Writes all columns of a recording in the plain format, without names of segments.
void write_recording(const recording::Recording& recording, const std::string& path);

/// Whether a page has means of the recording instead of its samples.
bool is_too_large(const std::string& path);

/// Such a recording as embedded in a page: its means over 1 s, the board's blocks, as a CSV of
/// the plain format.
struct PageRows {
  std::string csv;
  std::size_t samples = 0;  ///< of the recording
  std::size_t rows = 0;     ///< that remain
};

/// A sentence on what the page has of the recording `path`.
std::string words_of(const PageRows& rows, const std::string& path);

/// Throws InputError like read_recording().
PageRows page_rows(const std::string& path, const recording::ReadOptions& options);

}  // namespace fogcomp::cli
