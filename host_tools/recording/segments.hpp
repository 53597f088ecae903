#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "recording/row_range.hpp"

namespace fogcomp::recording {

enum class SegmentKind : std::uint8_t { soak, ramp_up, ramp_down };

/// A part of a run in which the chamber does one thing.
struct Segment {
  std::string name;  ///< unique within the run: "soak 20", "ramp 20..-40", "soak 20 (2)"
  SegmentKind kind = SegmentKind::soak;
  double start_s = 0;  ///< of its first row
  double end_s = 0;    ///< of its last row, and the length of one
  RowRange rows;       ///< of the series that it is a part of
};

/// Soaks and ramps that cover all rows in order, from the temperature alone (find_programme_parts),
/// or from the file's `segment` column if it has one; temperatures in names are rounded to degC. A
/// gap of more than 1 s starts a new segment: in less, as when a sample is lost at 200 Hz, neither
/// temperature nor drift moves. (stretch_starts has every gap.)
std::vector<Segment> find_segments(const Recording& recording);

/// The same segments in another series of the same run, of which `rows` have these times: a row
/// belongs to the segment that began last. Segments too short to have a row have none.
std::vector<Segment> segments_on(std::vector<Segment> segments, const std::vector<double>& time_s,
                                 RowRange rows);

/// The rows without a gap that `rows` consist of.
std::vector<RowRange> stretches_of(const Recording& recording, RowRange rows);

}  // namespace fogcomp::recording
