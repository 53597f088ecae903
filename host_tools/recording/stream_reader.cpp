#include "recording/stream_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "core/acquisition/reading_monitor.hpp"
#include "core/acquisition/sequence_monitor.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/extension_frame.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/stream_parser.hpp"
#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/long_recording.hpp"
#include "recording/recording_writer.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kDegcPerLsb = 1.0 / 65536;

/// A sample of a captured stream, to or from a board.
struct CapturedSample {
  std::uint16_t sequence = 0;
  double rate_dph = 0;
  double temperature_degc = 0;
  bool rate_valid = false;
  bool temperature_valid = false;
};

/// Converts the samples of a capture to rows of a Recording, with times from their numbers.
class SampleCollector {
 public:
  /// `frame_bytes`: per sample, to reserve memory. The arguments must outlive this object.
  SampleCollector(const InputFile& file, const ReadOptions& options, std::size_t frame_bytes)
      : rate_hz_(options.stream_rate_hz.value_or(kDefaultStreamRateHz)),
        watch_(options.watch),
        // Assumes an extension record of every input before each sample.
        long_recording_(options, file.size() / (frame_bytes + fog::kExtensionInputs *
                                                                  fog::kExtensionFrameBytes)) {
    recording_.file = file.path();
    const std::size_t rows = std::min(file.size() / frame_bytes + 1, long_recording_.part_rows());
    for (auto* column : {&recording_.time_s, &recording_.temperature_degc, &recording_.rate_dph}) {
      column->reserve(rows);
    }
  }

  /// Takes a value that is valid from the next sample until another one comes.
  void add(const fog::ExtensionRecord& record) {
    const double value = std::ldexp(record.value.raw(), -fog::ExtensionValue::fractional_bits);
    if (!column_info(column_of(record.input)).can_be(value)) return;
    if (record.input == fog::Input::temperature2 && !fog::is_possible(record.value)) return;
    extension_[extension_number(record.input)] = value;
  }

  void add(const CapturedSample& sample) {
    const fog::SequenceMonitor::Verdict verdict = sequence_.judge(sample.sequence);
    if (verdict.late) {  // its time has passed
      ++counts_.late_samples;
      return;
    }
    number_ = any_ ? number_ + verdict.missing + 1 : sample.sequence;
    any_ = true;
    counts_.missing_samples += verdict.missing;
    if (sample.temperature_valid) {
      temperature_degc_ = sample.temperature_degc;
      temperature_number_ = number_;
    }
    if (!sample.rate_valid || !holds_temperature()) {
      ++counts_.invalid_samples;
      return;
    }
    if (!sample.temperature_valid) ++counts_.held_temperatures;
    if (recording_.rows() == long_recording_.part_rows()) {
      LineNumbers lines;
      long_recording_.take(recording_, lines, recording_.file);
    }
    recording_.time_s.push_back(static_cast<double>(number_) / rate_hz_);
    recording_.temperature_degc.push_back(temperature_degc_);
    recording_.rate_dph.push_back(sample.rate_dph);
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      if (!extension_[i]) continue;
      // Rows before the first value get that value.
      recording_.extension[i].resize(recording_.rows() - 1, *extension_[i]);
      recording_.extension[i].push_back(*extension_[i]);
    }
  }

  /// Throws InputError if there was no valid sample. `what`: the kind of stream, for messages.
  Recording finish(std::size_t discarded_bytes, const char* what) {
    counts_.discarded_bytes = discarded_bytes;
    if (!any_) {
      throw InputError(recording_.file, std::string("neither text nor ") + what +
                                            ": it holds no good frame; is it the right file?");
    }
    if (recording_.rows() == 0 && long_recording_.rows_taken() == 0) {
      throw InputError(recording_.file, "no sample is valid: " + describe(counts_));
    }
    const std::string disorder = describe(counts_);
    if (!disorder.empty()) watch_.say(recording_.file, disorder);
    recording_.capture = counts_;
    if (!long_recording_.begun()) return std::move(recording_);
    LineNumbers lines;
    long_recording_.take(recording_, lines, recording_.file);
    Recording means = long_recording_.finish(recording_.file);
    means.capture = counts_;
    return means;
  }

 private:
  // Without a temperature a board holds its drift no longer than this, and then has no valid rate.
  bool holds_temperature() const {
    return temperature_number_ &&
           static_cast<double>(number_ - *temperature_number_) <= kHoldSeconds * rate_hz_;
  }

  double rate_hz_;
  const ReadWatch& watch_;
  Recording recording_;
  LongRecording long_recording_;
  CaptureCounts counts_;
  fog::SequenceMonitor sequence_;
  bool any_ = false;
  // Number of the sample: starts with its sequence number, then counts the time of the board.
  std::uint64_t number_ = 0;
  std::optional<std::uint64_t> temperature_number_;  // of the sample with the present temperature
  double temperature_degc_ = 0;
  std::array<std::optional<double>, fog::kExtensionInputs> extension_;
};

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

std::string describe(const CaptureCounts& counts) {
  std::string text;
  const auto add_count = [&text](std::size_t count, const std::string& what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + (what + std::to_string(count));
  };
  add_count(counts.discarded_bytes, "damaged bytes ");
  add_count(counts.missing_samples, "missing samples ");
  add_count(counts.late_samples, "late or repeated samples ");
  add_count(counts.invalid_samples, "invalid samples ");
  add_count(counts.held_temperatures, "held temperatures ");
  return text;
}

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
