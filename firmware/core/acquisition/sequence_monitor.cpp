#include "core/acquisition/sequence_monitor.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {
namespace {

constexpr std::int32_t kCircle = 1 << 16;  // of the sequence numbers
constexpr std::int32_t kMaxMissing = 1 << 30;

// Sequence and clock disagree where they are further apart than this: a board that was busy finds
// no more samples waiting than its receive buffer holds, and a sample rate that is off by more than
// 2 % is not the demodulator's (SampleRateMonitor).
constexpr std::int32_t kWaitingSamples = 64;
constexpr int kLog2OfRateError = 5;  // 3 %

// The number that is congruent to `skipped` modulo the circle and nearest to `expected`: below half
// a circle above it.
std::int32_t nearest(std::uint16_t skipped, std::int32_t expected) {
  const std::int32_t rounds = floor_shift(expected - skipped + kCircle / 2 - 1, 16);
  return skipped + rounds * kCircle;
}

std::int32_t magnitude(std::int32_t value) {
  return value < 0 ? -value : value;
}

}  // namespace

SequenceMonitor::SequenceMonitor(std::uint32_t sample_period_us)
    : samples_per_ms_((std::uint32_t{1000} << 20U) / sample_period_us) {}

SequenceMonitor::Verdict SequenceMonitor::judge(std::uint16_t sequence, SampleTime now) {
  const auto skipped = static_cast<std::uint16_t>(sequence - newest_ - unsigned{!first_});
  Verdict verdict;
  if (!first_) {
    const bool clock = now.known && newest_time_.known;
    const std::int32_t expected = clock ? samples_in(now.ms - newest_time_.ms) - 1 : 0;
    std::int32_t missing = nearest(skipped, expected);
    const bool contradicts = clock && magnitude(missing - expected) >
                                          kWaitingSamples + floor_shift(expected, kLog2OfRateError);
    if (missing < 0 && !contradicts && ++late_samples_ < kLateSamplesOfARestart) {
      verdict.status = Status::sequence_gap;
      verdict.late = true;
      return verdict;
    }
    // It counts anew. Samples that were taken for late ones turn out to have been time.
    if (contradicts || missing < 0) {
      missing = clock ? expected : static_cast<std::int32_t>(kLateSamplesOfARestart) - 1;
    }
    verdict.missing = missing > 0 ? static_cast<std::uint32_t>(missing) : 0U;
    verdict.status = status_if(skipped != 0 || missing > 0, Status::sequence_gap);
  }
  late_samples_ = 0;
  newest_ = sequence;
  newest_time_ = now;
  first_ = false;
  return verdict;
}

// Rounded to nearest; within 0.1 % up to periods of 10 s.
std::int32_t SequenceMonitor::samples_in(std::uint32_t passed_ms) const {
  const std::uint64_t samples = (std::uint64_t{passed_ms} * samples_per_ms_ + (1U << 19U)) >> 20U;
  return samples < kMaxMissing ? static_cast<std::int32_t>(samples) : kMaxMissing;
}

}  // namespace fog
