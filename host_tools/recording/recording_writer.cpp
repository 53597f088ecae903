#include "recording/recording_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/frames/sensor_frame.hpp"
#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kTemperatureLsbPerDegc = 65536;

// Rounds to the raw integer of a frame. Values beyond it are clamped and invalid, as from a
// demodulator at full scale.
struct RawValue {
  std::int32_t raw;
  bool valid;
};
RawValue to_raw(double value) {
  constexpr double kMin = std::numeric_limits<std::int32_t>::min();
  constexpr double kMax = std::numeric_limits<std::int32_t>::max();
  const double rounded = std::nearbyint(value);
  if (std::isnan(rounded)) return {0, false};
  return {static_cast<std::int32_t>(std::clamp(rounded, kMin, kMax)),
          rounded >= kMin && rounded <= kMax};
}

std::size_t index_of(const std::vector<Column>& columns, Column wanted) {
  const auto found = std::find(columns.begin(), columns.end(), wanted);
  if (found == columns.end()) {
    throw std::invalid_argument("a sensor stream needs time, rate and temperature");
  }
  return static_cast<std::size_t>(found - columns.begin());
}

}  // namespace

std::optional<fog::ExtensionFrame> extension_frame(fog::Input input, double value) {
  const auto [raw, fits] = to_raw(std::ldexp(value, fog::ExtensionValue::fractional_bits));
  if (!fits) return std::nullopt;
  return fog::encode_extension_frame({input, fog::ExtensionValue::from_raw(raw)});
}

RecordingWriter::RecordingWriter(const std::string& path, RecordingFormat format,
                                 std::vector<Column> columns, double scale_factor, double rate_hz)
    : file_(path),
      format_(format),
      columns_(std::move(columns)),
      scale_factor_(scale_factor),
      rate_hz_(rate_hz) {
  if (format_ != RecordingFormat::csv) return;
  std::string header;
  for (const Column column : columns_) {
    if (!header.empty()) header += ',';
    header += column_info(column).name;
  }
  file_.write(header + '\n');
}

void RecordingWriter::append(const std::vector<const double*>& values, std::size_t rows) {
  if (format_ == RecordingFormat::csv) {
    append_csv(values, rows);
  } else {
    append_stream(values, rows);
  }
}

void RecordingWriter::append_csv(const std::vector<const double*>& values, std::size_t rows) {
  std::array<char, kColumns.size() * (kLongestDecimal + 1)> line;
  for (std::size_t row = 0; row < rows; ++row) {
    char* end = line.data();
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c > 0) *end++ = ',';
      end = print_fixed(values[c][row], column_info(columns_[c]).decimals, end);
    }
    *end++ = '\n';
    file_.write(line.data(), static_cast<std::size_t>(end - line.data()));
  }
}

void RecordingWriter::append_stream(const std::vector<const double*>& values, std::size_t rows) {
  const double* time_s = values[index_of(columns_, Column::time_s)];
  const double* rate_dph = values[index_of(columns_, Column::rate_dph)];
  const double* temperature_degc = values[index_of(columns_, Column::temperature_degc)];
  const double counts_per_dph = scale_factor_ / kDphPerDegreePerSecond;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const auto column = static_cast<std::size_t>(columns_[c]);
      if (column < kFirstExtensionColumn) continue;
      const auto frame =
          extension_frame(fog::extension_input(column - kFirstExtensionColumn), values[c][row]);
      if (frame) file_.write(frame->data(), frame->size());
    }
    fog::SensorSample sample;
    // The number follows from the time, so that a gap in time is a gap in the sequence. The frame
    // keeps the low 16 bits: gaps of 65536 samples or more are shortened accordingly.
    sample.sequence = static_cast<std::uint16_t>(std::llround(time_s[row] * rate_hz_));
    const RawValue rate = to_raw(rate_dph[row] * counts_per_dph);
    sample.rate_counts = rate.raw;
    sample.gyro_valid = rate.valid;
    const RawValue temperature = to_raw(temperature_degc[row] * kTemperatureLsbPerDegc);
    sample.temperature_q16 = temperature.raw;
    sample.temperature_valid = temperature.valid;
    const fog::SensorFrame frame = fog::encode_sensor_frame(sample);
    file_.write(frame.data(), frame.size());
  }
}

void RecordingWriter::commit() {
  file_.commit();
}

}  // namespace fogcomp::recording
