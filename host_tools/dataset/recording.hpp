#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fogcomp {

/// A recording in memory, one vector per column, all of the same length or (a column that the file
/// does not have) empty. Columns and units: the contract's "Recordings".
struct Recording {
  std::string file;
  double period_s = 0;  ///< median sample spacing
  std::vector<double> time_s;
  std::vector<double> temperature_degc;
  std::vector<double> rate_dph;
  std::vector<double> input_rate_dph;
  std::vector<double> temperature2_degc;
  std::vector<double> magnetic_ut;
  std::vector<double> light_power_uw;
  std::vector<double> supply_v;
  std::vector<double> vibration_grms;
  /// First row of each stretch without a gap (spacing at most 1.5 periods); starts with 0.
  std::vector<std::size_t> stretch_starts;
  std::size_t bad_rows = 0;  ///< left out by skip_bad_rows

  std::size_t rows() const { return time_s.size(); }
};

struct ReadOptions {
  /// Counts per deg/s: needed for a file with `counts` instead of `rate_dph`, and for a captured
  /// sensor stream unless it is the default.
  std::optional<double> scale_factor;
  bool skip_bad_rows = false;
  /// Constant input rate (Earth rate by latitude and axis) for a file without that column.
  double default_input_rate_dph = 0;
  /// Sample rate of a captured sensor stream, which carries sequence numbers but no time.
  std::optional<double> stream_rate_hz;
};

/// Reads a CSV, or a captured sensor stream (told apart by content, not by name).
/// Throws InputError `FILE:LINE: what is wrong; what to do`.
Recording read_recording(const std::string& path, const ReadOptions& options);

}  // namespace fogcomp
