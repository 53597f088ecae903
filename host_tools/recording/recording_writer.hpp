#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/frames/extension_frame.hpp"
#include "recording/recording.hpp"
#include "support/output_file.hpp"

namespace fogcomp::recording {

enum class RecordingFormat : std::uint8_t {
  csv,
  sensor_stream,  ///< what the demodulator sends to the board
};

/// The extension record of a value; none for one that the format does not hold, as a demodulator
/// sends none beyond the end of its range.
std::optional<fog::ExtensionFrame> extension_frame(fog::Input input, double value);

/// Writes a recording in chunks, so that its length is not bounded by memory.
class RecordingWriter {
 public:
  /// `columns` are written in the order given; a sensor stream needs time, rate and temperature,
  /// has extension records for the inputs among the others, and leaves out the input rate.
  /// `scale_factor` is counts per deg/s and `rate_hz` numbers the samples by their time; both
  /// concern the stream only.
  RecordingWriter(const std::string& path, RecordingFormat format, std::vector<Column> columns,
                  double scale_factor, double rate_hz);

  /// `values[c][row]` belongs to column c; every column has `rows` values.
  void append(const std::vector<const double*>& values, std::size_t rows);

  /// As OutputFile's: of two outputs, each is flushed before one is committed.
  void flush() { file_.flush(); }
  /// Gives the file its name; without it nothing appears.
  void commit();

 private:
  void append_csv(const std::vector<const double*>& values, std::size_t rows);
  void append_stream(const std::vector<const double*>& values, std::size_t rows);

  OutputFile file_;
  RecordingFormat format_;
  std::vector<Column> columns_;
  double scale_factor_;
  double rate_hz_;
};

/// Counts per deg/s of the simulated gyro: one count is 2^-10 deg/h, the board's own resolution.
constexpr double kDefaultScaleFactor = 3600.0 * 1024.0;

}  // namespace fogcomp::recording
