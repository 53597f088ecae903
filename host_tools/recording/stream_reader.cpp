#include "recording/stream_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "core/acquisition/reading_monitor.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/kvh_frame.hpp"
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

// Byte positions in a KVH frame (firmware/SPEC.md).
constexpr std::uint32_t kKvhHeader = 0xFE81FF55U;
constexpr std::size_t kKvhRotationZ = 12;
constexpr std::size_t kKvhStatus = 28;
constexpr std::size_t kKvhSequence = 29;
constexpr std::size_t kKvhTemperature = 30;
constexpr std::size_t kKvhCrc = 32;
constexpr unsigned kKvhZValid = 1U << 2U;
constexpr unsigned kKvhSequences = 128;

const std::uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());
}

std::uint32_t load_big(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = (value << 8U) | bytes[i];
  return value;
}

bool is_kvh_frame(std::string_view bytes) {
  if (bytes.size() < fog::kKvhFrameBytes || load_big(bytes_of(bytes), 4) != kKvhHeader) {
    return false;
  }
  return load_big(bytes_of(bytes) + kKvhCrc, 4) ==
         fog::crc32(bytes_of(bytes), kKvhCrc, fog::kCrc32Initial);
}

// The sample of the compact frame with which `bytes` begin, if they do.
std::optional<fog::OutputSample> compact_sample(std::string_view bytes) {
  fog::OutputSample sample;
  std::uint16_t delay = 0;
  if (bytes.size() < fog::kCompactFrameBytes) return std::nullopt;
  if (!fog::decode_compact_frame(bytes_of(bytes), sample, delay)) return std::nullopt;
  return sample;
}

/// Samples of KVH frames, whose numbers have 7 bits.
class KvhSamples {
 public:
  CapturedSample take(const std::uint8_t* frame) {
    const unsigned sequence = frame[kKvhSequence];
    if (any_) number_ = static_cast<std::uint16_t>(number_ + (sequence - last_) % kKvhSequences);
    if (!any_) number_ = static_cast<std::uint16_t>(sequence);
    any_ = true;
    last_ = sequence;
    const std::uint32_t bits = load_big(frame + kKvhRotationZ, 4);
    float rate_radps = 0;
    std::memcpy(&rate_radps, &bits, sizeof rate_radps);
    const auto degc = static_cast<std::int16_t>(load_big(frame + kKvhTemperature, 2));
    const double rate_dph = static_cast<double>(rate_radps) * kDphPerDegreePerSecond * 180 / kPi;
    const bool valid = (frame[kKvhStatus] & kKvhZValid) != 0 && std::isfinite(rate_dph);
    return {number_, rate_dph, static_cast<double>(degc), valid, valid};
  }

 private:
  bool any_ = false;
  unsigned last_ = 0;
  std::uint16_t number_ = 0;
};

// The measured rate of the board. Whether its drift was valid does not matter.
CapturedSample measured(const fog::OutputSample& sample) {
  constexpr fog::Status kNotMeasured = fog::Status::gyro_invalid | fog::Status::rate_out_of_range |
                                       fog::Status::gyro_stuck | fog::Status::rate_jump |
                                       fog::Status::no_samples | fog::Status::self_test_failed;
  const std::int64_t raw = std::int64_t{sample.compensated.raw()} + sample.drift.raw();
  return {sample.sequence, std::ldexp(static_cast<double>(raw), -fog::Rate::fractional_bits),
          std::ldexp(sample.temperature.raw(), -fog::Temperature::fractional_bits),
          !has_any(sample.status, kNotMeasured),
          !has_any(sample.status, fog::Status::temperature_invalid)};
}

/// Finds the frames of one kind and passes their samples on.
class FrameFinder {
 public:
  FrameFinder(OutputFrames frames, SampleCollector& collector)
      : frames_(frames), collector_(collector) {}

  void take(std::string_view block) {
    bytes_.append(block);
    std::size_t at = 0;
    while (bytes_.size() - at >= fog::kKvhFrameBytes) at += frame_at(at);
    bytes_.erase(0, at);
  }
  /// Returns the number of bytes that belong to no good frame.
  std::size_t finish() {
    std::size_t at = 0;
    while (at < bytes_.size()) at += frame_at(at);
    return discarded_;
  }

 private:
  // Length of the frame at `at`, or 1 if none starts there.
  std::size_t frame_at(std::size_t at) {
    const std::string_view rest = std::string_view(bytes_).substr(at);
    if (is_kvh_frame(rest)) {
      if (frames_ == OutputFrames::kvh) collector_.add(kvh_.take(bytes_of(rest)));
      return fog::kKvhFrameBytes;
    }
    if (const std::optional<fog::OutputSample> sample = compact_sample(rest)) {
      if (frames_ == OutputFrames::compact) collector_.add(measured(*sample));
      return fog::kCompactFrameBytes;
    }
    ++discarded_;
    return 1;
  }

  OutputFrames frames_;
  SampleCollector& collector_;
  KvhSamples kvh_;
  std::string bytes_;
  std::size_t discarded_ = 0;
};

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

std::optional<OutputFrames> find_output_frames(std::string_view head) {
  bool kvh = false;
  std::size_t compact = 0;
  for (std::size_t at = 0; at < head.size() && compact < 2;) {
    const std::string_view rest = head.substr(at);
    if (is_kvh_frame(rest)) {
      kvh = true;
      at += fog::kKvhFrameBytes;
    } else if (compact_sample(rest)) {
      ++compact;  // one may be chance: its CRC has 16 bits
      at += fog::kCompactFrameBytes;
    } else {
      ++at;
    }
  }
  const bool all_of_it = compact == 1 && head.size() < 2 * fog::kCompactFrameBytes;
  if (compact > 1 || all_of_it) return OutputFrames::compact;
  return kvh ? std::optional(OutputFrames::kvh) : std::nullopt;
}

Recording read_output_stream(InputFile& file, OutputFrames frames, const ReadOptions& options) {
  const bool compact = frames == OutputFrames::compact;
  SampleCollector collector(file, options, compact ? fog::kCompactFrameBytes : fog::kKvhFrameBytes);
  FrameFinder finder(frames, collector);
  for (std::string_view block = file.next_block(); !block.empty(); block = file.next_block()) {
    finder.take(block);
  }
  Recording recording = collector.finish(finder.finish(), "what a board sends");
  options.watch.say(
      file.path(),
      compact ? "output of a board (compact frames): the rate is the measured one, its drift put "
                "back"
              : "output of a board (KVH frames): the rate is compensated already, denoised and "
                "late, the temperature in whole degC: a model of all the drift, fast noise and "
                "effects of the temperature rate cannot be seen in it; compact frames can show "
                "them");
  if (options.scale_factor) {
    options.watch.say(file.path(), "has rates, not counts; --scale-factor has no effect");
  }
  return recording;
}

}  // namespace fogcomp::recording
