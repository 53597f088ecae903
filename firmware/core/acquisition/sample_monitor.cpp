#include "core/acquisition/sample_monitor.hpp"

namespace fog {
namespace {

// Sequence numbers have 16 bits: a step of less than half the circle is samples lost, one of more
// is a sample that comes late or twice and does not move time.
constexpr std::uint32_t kMostMissing = 0x7FFF;

}  // namespace

SampleMonitor::Verdict SampleMonitor::judge(const SensorSample& sample) {
  Verdict verdict;
  if (!first_) {
    const auto skipped =
        static_cast<std::uint16_t>(static_cast<unsigned>(sample.sequence) - last_sequence_ - 1U);
    if (skipped != 0) verdict.status |= Status::sequence_gap;
    if (skipped <= kMostMissing) verdict.missing = skipped;
  }
  equal_counts_ = !first_ && sample.rate_counts == last_counts_ ? equal_counts_ + 1 : 1;
  // Saturates, so that a gyro that has been stuck for months is still stuck.
  if (equal_counts_ == 0) --equal_counts_;
  const bool stuck = parameters_.stuck_samples != 0 && equal_counts_ >= parameters_.stuck_samples;
  const auto temperature = Temperature::from_raw(sample.temperature_q16);
  const bool temperature_good = sample.temperature_valid && is_possible(temperature);
  verdict.status |= status_if(!sample.gyro_valid, Status::gyro_invalid);
  verdict.status |= status_if(stuck, Status::gyro_stuck);
  verdict.status |= status_if(!temperature_good, Status::temperature_invalid);
  last_sequence_ = sample.sequence;
  last_counts_ = sample.rate_counts;
  first_ = false;
  return verdict;
}

}  // namespace fog
