#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp {

enum class SegmentKind : std::uint8_t { soak, ramp_up, ramp_down };

/// A part of a recording in which the chamber does one thing.
struct Segment {
  std::string name;  ///< unique within the recording: "soak 20", "ramp 20..-40", "soak 20 (2)"
  SegmentKind kind = SegmentKind::soak;
  std::size_t first_row = 0;
  std::size_t end_row = 0;  ///< one past the last

  std::size_t rows() const { return end_row - first_row; }
};

/// Soaks and ramps that cover all rows in order, from the temperature alone (find_programme_parts),
/// or from the file's `segment` column if it has one; temperatures in names are rounded to degC. A
/// gap of more than 1 s starts a new segment: in less, as when a sample is lost at 200 Hz, neither
/// temperature nor drift moves. (stretch_starts has every gap.)
std::vector<Segment> find_segments(const Recording& recording);

/// The rows without a gap that `rows` [first, end) consist of.
struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - first; }
};
std::vector<RowRange> stretches_of(const Recording& recording, RowRange rows);

}  // namespace fogcomp
