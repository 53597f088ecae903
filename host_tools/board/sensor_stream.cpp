#include "board/sensor_stream.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/frames/sensor_frame.hpp"
#include "recording/recording_writer.hpp"
#include "series/block_series.hpp"

namespace fogcomp::board {
namespace {

constexpr std::size_t kRowsBetweenProgress = 4096;

std::int32_t rounded_to_int32(double value) {
  return static_cast<std::int32_t>(
      std::llround(std::clamp(value, double{INT32_MIN}, double{INT32_MAX})));
}

}  // namespace

void make_sensor_stream(const recording::Recording& recording, double scale_factor,
                        fog::InputMask extension, const TimedByteSink& sink,
                        const recording::ReadWatch& watch) {
  std::vector<std::uint8_t> piece;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    piece.clear();
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      const fog::Input input = fog::extension_input(i);
      if (!has(extension, input)) continue;
      const auto frame = recording::extension_frame(input, recording[input][row]);
      if (frame) piece.insert(piece.end(), frame->begin(), frame->end());
    }
    fog::SensorSample sample;
    const std::int64_t number = series::sample_number(recording, row);
    sample.sequence = static_cast<std::uint16_t>(number);
    sample.rate_counts = rounded_to_int32(recording.rate_dph[row] * scale_factor / 3600);
    sample.temperature_q16 = rounded_to_int32(recording.temperature_degc[row] * 65536);
    sample.gyro_valid = true;
    sample.temperature_valid = true;
    const fog::SensorFrame frame = fog::encode_sensor_frame(sample);
    piece.insert(piece.end(), frame.begin(), frame.end());
    const double time_ms = 1000 * recording.period_s * static_cast<double>(number);
    sink({piece.data(), piece.size()}, {true, static_cast<std::uint32_t>(std::llround(time_ms))});
    if (watch.progress && row % kRowsBetweenProgress == 0) {
      watch.progress("sending " + recording.file,
                     static_cast<double>(row) / static_cast<double>(recording.rows()));
    }
  }
}

}  // namespace fogcomp::board
