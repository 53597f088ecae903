#include "dataset/stream_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "core/acquisition/stream_parser.hpp"
#include "dataset/input_columns.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp {
namespace {

constexpr double kDegcPerLsb = 1.0 / 65536;
constexpr std::size_t kMaxBlocksWithoutFrame = 64;  // of 1 MiB: what comes then is no sensor's

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
        rate_hz_(options.stream_rate_hz.value_or(kDefaultStreamRateHz)) {
    recording_.file = file.path();
    const std::size_t rows = std::min(file.size() / fog::kSensorFrameBytes + 1, kMostRows);
    for (auto* column : {&recording_.time_s, &recording_.temperature_degc, &recording_.rate_dph}) {
      column->reserve(rows);
    }
  }

  /// A value that belongs to the next sample and holds until another one comes.
  void add(const fog::ExtensionRecord& record) {
    const double value = std::ldexp(record.value.raw(), -fog::ExtensionValue::fractional_bits);
    if (!input_column(record.input).can_be(value)) return;
    extension_[static_cast<std::size_t>(record.input)] = value;
  }

  void add(const fog::SensorSample& sample) {
    if (any_ && sample.sequence == static_cast<std::uint16_t>(number_)) {
      ++counts_.repeated_samples;
      return;
    }
    advance_to(sample.sequence);
    const double temperature_degc = sample.temperature_q16 * kDegcPerLsb;
    const bool temperature_valid =
        sample.temperature_valid && column_info(Column::temperature_degc).can_be(temperature_degc);
    if (temperature_valid) {
      temperature_degc_ = temperature_degc;
      has_temperature_ = true;
    }
    if (!sample.gyro_valid || !has_temperature_) {
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
      extension_column(i).resize(recording_.rows() - 1, *extension_[i]);
      extension_column(i).push_back(*extension_[i]);
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
      throw InputError(recording_.file, "no sample is valid: " + summary());
    }
    if (counts_.invalid_samples + counts_.held_temperatures + counts_.repeated_samples +
            counts_.missing_samples + counts_.discarded_bytes >
        0) {
      std::fprintf(stderr, "%s: %s\n", recording_.file.c_str(), summary().c_str());
    }
    recording_.capture = counts_;
    return std::move(recording_);
  }

 private:
  std::vector<double>& extension_column(std::size_t i) {
    return recording_.*input_column(static_cast<fog::Input>(i)).values;
  }

  void advance_to(std::uint16_t sequence) {
    if (!any_) {
      number_ = sequence;
      any_ = true;
      return;
    }
    const auto step = static_cast<std::uint16_t>(sequence - static_cast<std::uint16_t>(number_));
    number_ += step;
    counts_.missing_samples += step - 1U;
  }

  std::string summary() const {
    std::string text;
    const auto add_count = [&text](std::size_t count, const std::string& what) {
      if (count > 0) text += (text.empty() ? "" : ", ") + (what + std::to_string(count));
    };
    add_count(counts_.discarded_bytes, "damaged bytes ");
    add_count(counts_.missing_samples, "missing samples ");
    add_count(counts_.repeated_samples, "repeated samples ");
    add_count(counts_.invalid_samples, "invalid samples ");
    add_count(counts_.held_temperatures, "held temperatures ");
    return text;
  }

  double dph_per_count_;
  double rate_hz_;
  Recording recording_;
  CaptureCounts counts_;
  bool any_ = false;
  std::uint64_t number_ = 0;  // of the sample, counted from sequence number 0 before the first
  bool has_temperature_ = false;
  double temperature_degc_ = 0;
  std::array<std::optional<double>, fog::kExtensionInputs> extension_;
};

}  // namespace

bool is_sensor_stream(std::string_view head) {
  fog::StreamParser parser;
  for (const char character : head) {
    if (parser.feed(static_cast<std::uint8_t>(character)) != fog::StreamParser::Found::nothing) {
      return true;
    }
  }
  // A capture has zeros in every frame, UTF-16 in every character; a CSV with a stray one is still
  // a CSV, whose reader can name the line.
  constexpr std::ptrdiff_t kFewest = 50;  // one in fifty
  return std::count_if(head.begin(), head.end(), is_control) * kFewest >
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
    if (blocks_without_frame > kMaxBlocksWithoutFrame) {
      throw InputError(file.path(), format("no good frame in %zu MiB; is it the right file?",
                                           kMaxBlocksWithoutFrame));
    }
  }
  return collector.finish(bytes - good_bytes);
}

}  // namespace fogcomp
