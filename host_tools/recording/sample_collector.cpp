#include "recording/sample_collector.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/acquisition/reading_monitor.hpp"
#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "recording/stream_reader.hpp"
#include "support/input_error.hpp"

namespace fogcomp::recording {

SampleCollector::SampleCollector(const InputFile& file, const ReadOptions& options,
                                 std::size_t frame_bytes)
    : rate_hz_(options.stream_rate_hz.value_or(kDefaultStreamRateHz)),
      watch_(options.watch),
      // Assumes an extension record of every input before each sample.
      long_recording_(options, file.size() / (frame_bytes +
                                              fog::kExtensionInputs * fog::kExtensionFrameBytes)) {
  recording_.file = file.path();
  const std::size_t rows = std::min(file.size() / frame_bytes + 1, long_recording_.part_rows());
  for (auto* column : {&recording_.time_s, &recording_.temperature_degc, &recording_.rate_dph}) {
    column->reserve(rows);
  }
}

void SampleCollector::add(const fog::ExtensionRecord& record) {
  const double value = std::ldexp(record.value.raw(), -fog::ExtensionValue::fractional_bits);
  if (!column_info(column_of(record.input)).can_be(value)) return;
  if (record.input == fog::Input::temperature2 && !fog::is_possible(record.value)) return;
  extension_[extension_number(record.input)] = value;
}

void SampleCollector::add(const CapturedSample& sample) {
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

Recording SampleCollector::finish(std::size_t discarded_bytes, const char* what) {
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

// Without a temperature a board holds its drift no longer than this, and then has no valid rate.
bool SampleCollector::holds_temperature() const {
  return temperature_number_ &&
         static_cast<double>(number_ - *temperature_number_) <= kHoldSeconds * rate_hz_;
}

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

}  // namespace fogcomp::recording
