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
#include "core/acquisition/sequence_monitor.hpp"
#include "core/frames/stream_parser.hpp"
#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
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

/// Turns samples into rows of a Recording.
class SampleCollector {
 public:
  SampleCollector(const InputFile& file, const ReadOptions& options)
      : dph_per_count_(kDphPerDegreePerSecond /
                       options.scale_factor.value_or(
                           options.model_scale_factor.value_or(kDefaultScaleFactor))),
        rate_hz_(options.stream_rate_hz.value_or(kDefaultStreamRateHz)),
        watch_(options.watch) {
    recording_.file = file.path();
    const std::size_t rows = std::min(file.size() / fog::kSensorFrameBytes + 1, kMostRows);
    for (auto* column : {&recording_.time_s, &recording_.temperature_degc, &recording_.rate_dph}) {
      column->reserve(rows);
    }
  }

  /// A value that belongs to the next sample and holds until another one comes.
  void add(const fog::ExtensionRecord& record) {
    const double value = std::ldexp(record.value.raw(), -fog::ExtensionValue::fractional_bits);
    if (!column_info(column_of(record.input)).can_be(value)) return;
    if (record.input == fog::Input::temperature2 && !fog::is_possible(record.value)) return;
    extension_[extension_number(record.input)] = value;
  }

  void add(const fog::SensorSample& sample) {
    const fog::SequenceMonitor::Verdict verdict = sequence_.judge(sample.sequence);
    if (verdict.late) {  // its time has passed
      ++counts_.late_samples;
      return;
    }
    number_ = any_ ? number_ + verdict.missing + 1 : sample.sequence;
    any_ = true;
    counts_.missing_samples += verdict.missing;
    const bool temperature_valid =
        sample.temperature_valid &&
        fog::is_possible(fog::Temperature::from_raw(sample.temperature_q16));
    if (temperature_valid) {
      temperature_degc_ = sample.temperature_q16 * kDegcPerLsb;
      temperature_number_ = number_;
    }
    if (!sample.gyro_valid || !holds_temperature()) {
      ++counts_.invalid_samples;
      return;
    }
    if (!temperature_valid) ++counts_.held_temperatures;
    if (recording_.rows() == kMostRows) {
      throw InputError(recording_.file, format("more than %zu million samples; cut the capture",
                                               kMostRows / 1'000'000));
    }
    recording_.time_s.push_back(static_cast<double>(number_) / rate_hz_);
    recording_.temperature_degc.push_back(temperature_degc_);
    recording_.rate_dph.push_back(sample.rate_counts * dph_per_count_);
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      if (!extension_[i]) continue;
      // Rows before the first value have that one too.
      recording_.extension[i].resize(recording_.rows() - 1, *extension_[i]);
      recording_.extension[i].push_back(*extension_[i]);
    }
  }

  Recording finish(std::size_t discarded_bytes) {
    counts_.discarded_bytes = discarded_bytes;
    if (!any_) {
      throw InputError(recording_.file,
                       "neither text nor a sensor stream: it holds no good frame; is it the right "
                       "file?");
    }
    if (recording_.rows() == 0) {
      throw InputError(recording_.file, "no sample is valid: " + describe(counts_));
    }
    const std::string disorder = describe(counts_);
    if (!disorder.empty()) {
      watch_.say(recording_.file, disorder);
    }
    recording_.capture = counts_;
    return std::move(recording_);
  }

 private:
  // A board without a temperature has a drift no longer than this, and then no valid rate.
  bool holds_temperature() const {
    return temperature_number_ &&
           static_cast<double>(number_ - *temperature_number_) <= kHoldSeconds * rate_hz_;
  }

  double dph_per_count_;
  double rate_hz_;
  const ReadWatch& watch_;
  Recording recording_;
  CaptureCounts counts_;
  fog::SequenceMonitor sequence_;
  bool any_ = false;
  // Of the sample. The first has its sequence number; from there on it counts the time of the
  // board.
  std::uint64_t number_ = 0;
  std::optional<std::uint64_t> temperature_number_;  // of the sample whose temperature stands
  double temperature_degc_ = 0;
  std::array<std::optional<double>, fog::kExtensionInputs> extension_;
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
  SampleCollector collector(file, options);
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
          collector.add(parser.sample());
          break;
      }
    }
    // A pipe may never end.
    blocks_without_frame = good_bytes > good_before ? 0 : blocks_without_frame + 1;
    if (blocks_without_frame > rules::kMaxBlocksWithoutFrame) {
      throw InputError(file.path(), format("no good frame in %zu MiB; is it the right file?",
                                           rules::kMaxBlocksWithoutFrame));
    }
  }
  return collector.finish(bytes - good_bytes);
}

}  // namespace fogcomp::recording
