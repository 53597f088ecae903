#include "recording/stream_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "core/acquisition/reading_monitor.hpp"
#include "core/frames/stream_parser.hpp"
#include "recording/decision_rules.hpp"
#include "recording/recording_writer.hpp"
#include "recording/sample_collector.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kDegcPerLsb = 1.0 / 65536;

bool is_control(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20U && character != '\t' && character != '\n' && character != '\r';
}

CapturedSample captured(const fog::SensorSample& sample, double dph_per_count) {
  const bool possible = fog::is_possible(fog::Temperature::from_raw(sample.temperature_q16));
  return {sample.sequence, sample.rate_counts * dph_per_count, sample.temperature_q16 * kDegcPerLsb,
          sample.gyro_valid, sample.temperature_valid && possible};
}

}  // namespace

bool is_sensor_stream(std::string_view head) {
  fog::StreamParser parser;
  for (const char character : head) {
    if (parser.feed(static_cast<std::uint8_t>(character)) != fog::StreamParser::Found::nothing) {
      return true;
    }
  }
  return std::count_if(head.begin(), head.end(), is_control) * rules::kControlOneIn >
         static_cast<std::ptrdiff_t>(head.size());
}

Recording read_sensor_stream(InputFile& file, const ReadOptions& options) {
  const double dph_per_count =
      kDphPerDegreePerSecond /
      options.scale_factor.value_or(options.model_scale_factor.value_or(kDefaultScaleFactor));
  SampleCollector collector(file, options, fog::kSensorFrameBytes);
  fog::StreamParser parser;
  std::size_t bytes = 0;
  std::size_t good_bytes = 0;
  std::size_t blocks_without_frame = 0;
  for (std::string_view block = file.next_block(); !block.empty(); block = file.next_block()) {
    bytes += block.size();
    const std::size_t good_before = good_bytes;
    for (const char character : block) {
      switch (parser.feed(static_cast<std::uint8_t>(character))) {
        case fog::StreamParser::Found::nothing:
          break;
        case fog::StreamParser::Found::extension:
          good_bytes += fog::kExtensionFrameBytes;
          collector.add(parser.extension());
          break;
        case fog::StreamParser::Found::sample:
          good_bytes += fog::kSensorFrameBytes;
          collector.add(captured(parser.sample(), dph_per_count));
          break;
      }
    }
    // A pipe may be endless.
    blocks_without_frame = good_bytes > good_before ? 0 : blocks_without_frame + 1;
    if (blocks_without_frame > rules::kMaxBlocksWithoutFrame) {
      throw InputError(file.path(), format("no good frame in %zu MiB; is it the right file?",
                                           rules::kMaxBlocksWithoutFrame));
    }
  }
  return collector.finish(bytes - good_bytes, "a sensor stream");
}

}  // namespace fogcomp::recording
