#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/signal/inputs.hpp"
#include "recording/board_limits.hpp"
#include "recording/mask.hpp"

namespace fogcomp::recording {

/// Longest recording of which every row is stored: 27 h at 200 Hz; 0.5 GB in memory with three
/// columns. Longer ones are stored as means (long_recording.hpp).
constexpr std::size_t kMaxRows = 20'000'000;

/// Other contents of a captured sensor stream.
struct CaptureCounts {
  /// Left out: gyro not valid, or no temperature yet, or none for longer than a board holds its
  /// drift.
  std::size_t invalid_samples = 0;
  std::size_t held_temperatures = 0;  ///< invalid or impossible: replaced by the last valid one
  std::size_t late_samples = 0;       ///< late or repeated, as judged by the board: left out
  std::size_t missing_samples = 0;    ///< lost, as counted by the board
  std::size_t discarded_bytes = 0;    ///< part of no good frame
};

/// Columns of a recording. From kFirstExtensionColumn on: the extension inputs, in their order.
enum class Column : std::uint8_t { time_s, temperature_degc, rate_dph, input_rate_dph, uptime_s };
constexpr std::size_t kFirstExtensionColumn = 5;

/// A recording in memory, one vector per column; all have the same length or, for missing columns,
/// are empty. Columns and units: columns.hpp.
struct Recording {
  std::string file;
  /// Mean sample spacing within the stretches, s; 0 for one row, and for a table.
  double period_s = 0;
  std::vector<double> time_s;
  std::vector<double> temperature_degc;
  std::vector<double> rate_dph;
  std::vector<double> input_rate_dph;
  std::vector<double> uptime_s;  ///< since the last power-on, where time_s goes on after it
  std::array<std::vector<double>, fog::kExtensionInputs> extension;
  /// First row of each stretch without a gap (spacing at most 1.5 times the median) or restart;
  /// starts with 0.
  std::vector<std::size_t> stretch_starts;
  /// From a column `segment`: each text and its first row; else empty.
  struct Label {
    std::size_t first_row;
    std::string text;
  };
  std::vector<Label> labels;
  /// Rows with a reading of the temperature, where others lie on lines between them; empty: each
  /// row has one.
  std::vector<bool> temperature_is_read;
  /// Usually at most between these readings, and their smallest difference. 0: each row has one.
  /// HUGE_VAL: none was measured, one value was given.
  double temperature_period_s = 0;
  double temperature_step_degc = 0;
  bool is_table = false;  ///< of means at steady temperatures (become_table())
  /// time_s starts at the first row, because the file has calendar times.
  bool power_on_unknown = false;
  /// With power_on_unknown: the first row's time, seconds since 1970 if its calendar is known.
  double first_date_s = 0;
  std::size_t rows_per_row = 1;  ///< rows of the file per row; above 1 if it is too long for memory
  std::size_t bad_rows = 0;      ///< left out by skip_bad_rows
  std::size_t empty_rows = 0;    ///< left out because of a missing value
  std::size_t refused_rows = 0;  ///< left out because the board would refuse them
  std::optional<CaptureCounts> capture;
  std::vector<Mask> masks;  ///< times whose rates are not used

  std::size_t rows() const { return time_s.size(); }
  /// Whether the power was off before a row, as its uptime says.
  bool restarts_at(std::size_t row) const {
    return row > 0 && !uptime_s.empty() && uptime_s[row] < uptime_s[row - 1];
  }
  std::size_t restarts() const;

  std::vector<double>& operator[](Column column);
  const std::vector<double>& operator[](Column column) const;
  /// Column of an extension input.
  std::vector<double>& operator[](fog::Input input) { return extension[extension_number(input)]; }
  const std::vector<double>& operator[](fog::Input input) const {
    return extension[extension_number(input)];
  }
};

/// Observer of the reading of a file. Both functions may be empty.
struct ReadWatch {
  /// Called with a line `FILE: what` for each kind of left-out or ignored data.
  std::function<void(const std::string&)> remark{};
  /// Called with the fraction done, 0..1, and the stage "reading FILE" or "sending FILE".
  std::function<void(const std::string& stage, double done)> progress{};

  void say(const std::string& file, const std::string& what) const {
    if (remark) remark(file + ": " + what);
  }
};

struct ReadOptions {
  /// Counts per deg/s: needed for a file with `counts` instead of `rate_dph`, and for a captured
  /// sensor stream unless it is kDefaultScaleFactor.
  std::optional<double> scale_factor;
  /// Scale factor of the present model: for files that contain only counts, if no other is given.
  std::optional<double> model_scale_factor;
  /// Limits by which the board judges the rate; without given ones, those of the present model.
  GivenLimits limits{};
  GyroLimits model_limits{};
  /// Assignment of a CSV's columns: "time=Time[ms],rate=Gyro_X[deg/s]" (column_map.hpp); "": by
  /// their names.
  std::string columns{};
  /// The same as remembered by the present model: for files with all of those names, if nothing
  /// else is given.
  std::string model_columns{};
  /// Of a CSV with the rows of several sensors those that are read: "SensorId=1" (row_filter.hpp);
  /// "": all, and several sensors are refused.
  std::string where{};
  std::vector<Mask> masks{};
  std::vector<Cut> cuts{};  ///< made by runs::read_runs()
  /// Decimal mark of a CSV, whose other mark then parts thousands; nothing: as its numbers show.
  std::optional<bool> decimal_comma{};
  /// The same as remembered by the present model: for files that leave it open.
  std::optional<bool> model_decimal_comma{};
  /// Each line of a CSV is the mean of a steady temperature, in any order; times are not read.
  bool is_table = false;
  bool skip_bad_rows = false;
  /// Keeps the samples that the board would refuse: for the board's own code, which judges them
  /// itself.
  bool keep_refused_rows = false;
  /// Refuses a recording of more than kMaxRows instead of taking means: for outputs row by row.
  bool every_row = false;
  /// Constant input rate (Earth rate by latitude and axis) for a file without that column, which is
  /// added; with 0 the column stays empty.
  double default_input_rate_dph = 0;
  /// Sample rate of a captured sensor stream, which has sequence numbers but no time (default
  /// kDefaultStreamRateHz), and of a CSV without times.
  std::optional<double> stream_rate_hz;
  /// Of all rows of a CSV without temperatures.
  std::optional<double> temperature_degc{};
  /// A file whose columns complete those of a CSV by their times (join_file()), and its own map
  /// of columns; "": none.
  std::string join{};
  std::string join_columns{};
  /// Of a file that is joined: its rates are not needed.
  bool without_rate = false;
  ReadWatch watch{};
};

class InputFile;

/// Measured rate less input rate (0 if the file has none): the signal in which drift and noise are
/// analysed.
std::vector<double> bias_dph(const Recording& recording);

/// Resolution of a recording's rate, and whether the rate changes at all.
struct RateResolution {
  double step_dph = 0;   ///< smallest non-zero step between rows; 0: none
  double range_dph = 0;  ///< max - min
  double size_dph = 0;   ///< largest magnitude

  /// Whether the rate changes by more than the rounding of numbers of its size (at least 1 deg/h).
  /// A gyro's rate does: its noise is 10^9 times larger.
  bool varies() const;
  /// Standard deviation of a row's rounding: uniform within a step, or the rounding of a sum of
  /// products if such numbers have more digits.
  double rounding_dph() const;
};
RateResolution rate_resolution(const Recording& recording);

/// Throws InputError if a recording of two or more rows has a constant rate: the gyro is off or not
/// connected.
void require_varying_rate(const Recording& recording);

constexpr double kDefaultStreamRateHz = 200;

/// Reads a CSV of any layout (csv_layout.hpp), or a captured sensor stream (recognised by content,
/// not by name); "-" is standard input. Rows that the board would refuse (row_judge.cpp) are left
/// out. Ignored and left-out data are reported to options.watch. Throws InputError `FILE:LINE: what
/// is wrong; what to do`.
Recording read_recording(const std::string& path, const ReadOptions& options);
/// The same from an open file of which nothing has been read yet.
Recording read_recording(InputFile& file, const ReadOptions& options);

}  // namespace fogcomp::recording
