#include "compare/run_in_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "noise/noise_floor.hpp"
#include "recording/rate_resolution.hpp"
#include "series/rows.hpp"
#include "support/text.hpp"

namespace fogcomp::compare {
namespace {

// Rounded down to two digits.
double rounded_down(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 1);
  return step * std::floor(value / step);
}

// Notes about ramps and soaks that rows of that length do not separate. A segment of two rows'
// length always contains a whole row; a shorter one may be averaged with its neighbours. Less than
// a tenth of the time may be pieces between gaps.
std::vector<std::string> long_row_notes(const recording::Recording& recording,
                                        const std::vector<recording::Segment>& segments,
                                        double row_s) {
  if (row_s <= recording.period_s || segments.size() < 2) return {};
  std::size_t parts = 0;
  double in_parts_s = 0;
  double whole_s = 0;
  double shortest_s = HUGE_VAL;
  std::string shortest;
  for (const recording::Segment& segment : segments) {
    const double length_s = segment.end_s - segment.start_s;
    whole_s += length_s;
    if (length_s >= rules::kShortSegmentRows * row_s) continue;
    ++parts;
    in_parts_s += length_s;
    if (length_s >= shortest_s) continue;
    shortest_s = length_s;
    shortest = segment.name;
  }
  if (in_parts_s <= rules::kMinShareOfShortSegments * whole_s) return {};
  return {
      format("%s: rows of %.4g s average ramps and soaks together: %zu of its %s shorter than "
             "two rows (%s: %.4g s); use an --average of %.4g or less",
             recording.file.c_str(), row_s, parts,
             (counted(segments.size(), "part") + (parts == 1 ? " is" : " are")).c_str(),
             shortest.c_str(), shortest_s,
             std::max(recording.period_s, rounded_down(shortest_s / rules::kShortSegmentRows)))};
}

}  // namespace

RunInBlocks run_in_blocks(const recording::Recording& recording, double average_s) {
  recording::require_varying_rate(recording);
  RunInBlocks run;
  run.file = recording.file;
  run.files = {recording.file};
  run.refused_rows = recording.refused_rows;
  run.blocks = series::make_blocks(recording);
  run.segments = recording::find_segments(recording);
  run.average_s = average_s;
  // Actual row length: a whole number of blocks.
  const double row_s = series::row_length_s(average_s, run.blocks.block_s);
  run.noise_floor_dph = noise::noise_floor_dph(recording, row_s);
  run.notes = long_row_notes(recording, run.segments, row_s);
  if (recording.power_on_unknown && recording.uptime_s.empty()) {
    run.notes.push_back(recording.file +
                        ": power-on is not known: effects of the time since then (warm_up, aging) "
                        "count from its first sample");
  }
  return run;
}

bool have_several_power_ons(const std::vector<RunInBlocks>& runs) {
  if (runs.size() > 1) return true;
  return std::any_of(runs.begin(), runs.end(), [](const RunInBlocks& run) {
    return std::any_of(run.blocks.blocks.begin(), run.blocks.blocks.end(),
                       [](const series::BlockSeries::Block& block) { return block.restarts; });
  });
}

}  // namespace fogcomp::compare
