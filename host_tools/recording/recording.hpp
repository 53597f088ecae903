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

/// Longest recording of which every row is kept: 27 h at 200 Hz; 0.5 GB in memory with three
/// columns. Of a longer one means of neighbours are (long_recording.hpp).
constexpr std::size_t kMaxRows = 20'000'000;

/// What a captured sensor stream held besides the rows.
struct CaptureCounts {
  /// Left out: gyro not valid, or no temperature yet, or none for as long as a board holds a drift.
  std::size_t invalid_samples = 0;
  std::size_t held_temperatures = 0;  ///< not valid or not possible: the last valid one stands
  std::size_t late_samples = 0;       ///< late or repeated, as the board judges it: left out
  std::size_t missing_samples = 0;    ///< that never came, as the board counts them
  std::size_t discarded_bytes = 0;    ///< part of no good frame
};

/// Columns of a recording. From kFirstExtensionColumn on: the inputs that come in extension
/// records, in their order.
enum class Column : std::uint8_t { time_s, temperature_degc, rate_dph, input_rate_dph };
constexpr std::size_t kFirstExtensionColumn = 4;

/// A recording in memory, one vector per column, all of the same length or (a column that the file
/// does not have) empty. Columns and units: the contract's "Recordings".
struct Recording {
  std::string file;
  /// Mean sample spacing within the stretches; 0 for one row.
  double period_s = 0;
  std::vector<double> time_s;
  std::vector<double> temperature_degc;
  std::vector<double> rate_dph;
  std::vector<double> input_rate_dph;
  std::array<std::vector<double>, fog::kExtensionInputs> extension;
  /// First row of each stretch without a gap (spacing at most 1.5 times the median); starts with 0.
  std::vector<std::size_t> stretch_starts;
  /// From a column `segment`: each text and the first row where it stands; else empty.
  struct Label {
    std::size_t first_row;
    std::string text;
  };
  std::vector<Label> labels;
  /// time_s begins with the first row, whose time was one of the calendar.
  bool power_on_unknown = false;
  std::size_t rows_per_row = 1;  ///< of the file: more than one where it is too long for memory
  std::size_t bad_rows = 0;      ///< left out by skip_bad_rows
  std::size_t empty_rows = 0;    ///< left out for a value that the file does not have
  std::size_t refused_rows = 0;  ///< left out because the board would refuse them
  std::optional<CaptureCounts> capture;
  std::vector<Mask> masks;  ///< where its rates do not count

  std::size_t rows() const { return time_s.size(); }

  std::vector<double>& operator[](Column column);
  const std::vector<double>& operator[](Column column) const;
  /// Of the inputs that come in extension records.
  std::vector<double>& operator[](fog::Input input) { return extension[extension_number(input)]; }
  const std::vector<double>& operator[](fog::Input input) const {
    return extension[extension_number(input)];
  }
};

/// Who hears of a file that is read. Either may be empty.
struct ReadWatch {
  /// What is left out or ignored, `FILE: what`, one line per kind.
  std::function<void(const std::string&)> remark{};
  /// How much of it is done, 0..1, by "reading FILE" or "sending FILE".
  std::function<void(const std::string& stage, double done)> progress{};

  void say(const std::string& file, const std::string& what) const {
    if (remark) remark(file + ": " + what);
  }
};

struct ReadOptions {
  /// Counts per deg/s: needed for a file with `counts` instead of `rate_dph`, and for a captured
  /// sensor stream unless it is kDefaultScaleFactor.
  std::optional<double> scale_factor;
  /// The same as the model in hand has it: for files that have nothing but counts, where no other
  /// is given.
  std::optional<double> model_scale_factor;
  /// By which the board judges the rate, and those of the model in hand where none are given.
  GivenLimits limits{};
  GyroLimits model_limits{};
  /// Which column of a CSV is which: "time=Time[ms],rate=Gyro_X[deg/s]" (column_map.hpp); "": by
  /// their names.
  std::string columns{};
  /// The same as the model in hand remembers it: for files that have all of those names, where
  /// nothing else is given.
  std::string model_columns{};
  std::vector<Mask> masks{};
  bool skip_bad_rows = false;
  /// Keeps the rows that the board would refuse: for its own code, which judges them itself.
  bool keep_refused_rows = false;
  /// Refuses a recording of more than kMaxRows rather than taking means: for what is written row
  /// by row.
  bool every_row = false;
  /// Constant input rate (Earth rate by latitude and axis) for a file without that column, which it
  /// then gets; left at 0 the column stays empty.
  double default_input_rate_dph = 0;
  /// Sample rate of a captured sensor stream, which carries sequence numbers but no time; without
  /// it kDefaultStreamRateHz.
  std::optional<double> stream_rate_hz;
  ReadWatch watch{};
};

class InputFile;

/// Measured rate less input rate (0 where the file has none): what drift and noise are looked for
/// in.
std::vector<double> bias_dph(const Recording& recording);

constexpr double kDefaultStreamRateHz = 200;

/// Reads a CSV of any layout (csv_layout.hpp), or a captured sensor stream (told apart by content,
/// not by name); "-" is standard input. Rows that the
/// board would refuse (row_judge.hpp) are left out. What was ignored or left out
/// is told to options.watch. Throws InputError `FILE:LINE: what is wrong; what to do`.
Recording read_recording(const std::string& path, const ReadOptions& options);
/// The same from a file that is open, of which nothing has been taken yet.
Recording read_recording(InputFile& file, const ReadOptions& options);

}  // namespace fogcomp::recording
