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
  sensor_stream,  ///< from the demodulator to the board
};

/// Extension record of a value; none if the format cannot hold it, like a demodulator beyond its
/// range.
std::optional<fog::ExtensionFrame> extension_frame(fog::Input input, double value);

/// Writes a recording in chunks, so that memory does not limit its length.
class RecordingWriter {
 public:
  /// `columns` are written in the given order. A sensor stream needs time, rate and temperature,
  /// has extension records for other inputs, and no input rate. `scale_factor` (counts per deg/s)
  /// and `rate_hz` (numbers the samples by their time) are for streams only.
  RecordingWriter(const std::string& path, RecordingFormat format, std::vector<Column> columns,
                  double scale_factor, double rate_hz);

  /// `values[c][row]` belongs to column c; every column has `rows` values.
  void append(const std::vector<const double*>& values, std::size_t rows);

  /// As for OutputFile: of two outputs, flush both before committing one.
  void flush() { file_.flush(); }
  /// Gives the file its name; without commit no file appears.
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
