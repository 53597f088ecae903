#include "board/sensor_stream.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/frames/sensor_frame.hpp"
#include "recording/recording_writer.hpp"
#include "recording/stream_reader.hpp"
#include "series/block_series.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

constexpr std::size_t kRowsBetweenProgress = 4096;

std::int32_t rounded_to_int32(double value) {
  return static_cast<std::int32_t>(
      std::llround(std::clamp(value, double{INT32_MIN}, double{INT32_MAX})));
}

// The board counts time from its first sample: it does not know the time before a recording.
void warn_of_late_start(const recording::Recording& recording, const recording::ReadWatch& watch) {
  if (recording.time_s[0] <= recording.period_s) return;
  watch.say(recording.file,
            format("begins at %g s after power-on; the board's time begins with its first sample",
                   recording.time_s[0]));
}

// A sensor stream has one power-on.
void warn_of_restart(const recording::Recording& recording, const recording::ReadWatch& watch) {
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    if (!recording.restarts_at(row)) continue;
    watch.say(recording.file,
              format("was switched on again at %g s; the board sees it as if it had stayed on",
                     recording.time_s[row]));
    return;
  }
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

StreamSource::StreamSource(const std::string& path, const recording::ReadOptions& options,
                           double scale_factor, fog::InputMask needs)
    : scale_factor_(scale_factor),
      extension_(needs & fog::kAllExtensionInputs),
      watch_(options.watch) {
  auto file = std::make_unique<recording::InputFile>(path, options.watch.progress);
  if (recording::find_output_frames(file->peek())) {
    throw InputError(path,
                     "is the output of a board; give its input: a recording of the "
                     "gyro or a capture of the sensor stream");
  }
  if (recording::is_sensor_stream(file->peek())) {
    capture_ = std::move(file);
    return;
  }
  recording::ReadOptions all_rows = options;
  all_rows.keep_refused_rows = true;
  all_rows.every_row = true;
  recording_ = recording::read_recording(*file, all_rows);
  if (has(needs, fog::Input::elapsed)) warn_of_late_start(recording_, watch_);
  warn_of_restart(recording_, watch_);
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (!has(extension_, input.input) || !recording_[input.input].empty()) continue;
    throw InputError(path, std::string("has no column ") + input.column +
                               ", which the model needs; replay a recording that has it");
  }
}

void StreamSource::send(const TimedByteSink& sink) {
  if (!capture_) {
    make_sensor_stream(recording_, scale_factor_, extension_, sink, watch_);
    return;
  }
  for (;;) {
    const std::string_view block = capture_->next_block();
    if (block.empty()) return;
    sink({reinterpret_cast<const std::uint8_t*>(block.data()), block.size()}, {});
  }
}

}  // namespace fogcomp::board
