#include "core/acquisition/sequence_monitor.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {
namespace {

constexpr std::int32_t kSequenceNumbers = 1 << 16;  // number of sequence numbers
constexpr std::int32_t kMaxMissing = 1 << 30;

// Sequence and clock contradict each other if they differ by more than this. While the board is
// busy, at most the receive buffer fills with samples; a sample rate that is off by more than 2 %
// is a fault of its own (SampleRateMonitor).
constexpr std::int32_t kWaitingSamples = 64;
constexpr int kLog2OfRateError = 5;  // 3 %

// The number congruent to `skipped` modulo kSequenceNumbers and nearest to `expected`; ties
// upwards.
std::int32_t nearest(std::uint16_t skipped, std::int32_t expected) {
  const std::int32_t rounds = floor_shift(expected - skipped + kSequenceNumbers / 2 - 1, 16);
  return skipped + rounds * kSequenceNumbers;
}

std::int32_t magnitude(std::int32_t value) {
  return value < 0 ? -value : value;
}

}  // namespace

SequenceMonitor::SequenceMonitor(std::uint32_t sample_period_us)
    : samples_per_ms_((std::uint32_t{1000} << 20U) / sample_period_us),
      max_doubt_(static_cast<std::int32_t>(kDoubtUs / sample_period_us)) {}

SequenceMonitor::Verdict SequenceMonitor::judge(std::uint16_t sequence, SampleTime now) {
  if (first_) newest_ = sequence - 1U;
  first_ = false;
  const auto skipped = static_cast<std::uint16_t>(sequence - newest_ - 1U);
  const bool clock = now.known && newest_time_.known;
  const std::int32_t expected = clock ? samples_in(now.ms - newest_time_.ms) - 1 : 0;
  std::int32_t missing = nearest(skipped, expected);
  const bool contradicts = clock && magnitude(missing - expected) >
                                        kWaitingSamples + floor_shift(expected, kLog2OfRateError);
  Verdict verdict;
  if (missing < 0 && !contradicts && ++late_samples_ < kLateSamplesForRestart) {
    verdict.status = Status::sequence_gap;
    verdict.late = true;
    return verdict;
  }
  // The demodulator has restarted its count. Samples taken for late ones were time that passed.
  if (contradicts || missing < 0) {
    missing = clock ? expected : static_cast<std::int32_t>(kLateSamplesForRestart) - 1;
    doubt_ = max_doubt_;  // of no use with a clock
  }
  verdict.missing = missing > 0 ? static_cast<std::uint32_t>(missing) : 0U;
  verdict.status = status_if((skipped | verdict.missing) != 0, Status::sequence_gap);
  if (!clock) verdict.doubtful = is_doubtful(verdict.missing);
  late_samples_ = 0;
  newest_ = sequence;
  newest_time_ = now;
  return verdict;
}

// Without a clock fewer than 2^15 samples are missing.
bool SequenceMonitor::is_doubtful(std::uint32_t missing) {
  const std::int32_t doubt = doubt_ + kDoubtPerSample * static_cast<std::int32_t>(missing);
  const bool doubtful = doubt > max_doubt_;
  doubt_ = doubtful || doubt <= 0 ? 0 : doubt - 1;
  return doubtful;
}

// Samples in `passed_ms`, rounded to nearest; within 0.1 % for periods up to 10 s.
std::int32_t SequenceMonitor::samples_in(std::uint32_t passed_ms) const {
  const std::uint64_t samples = (std::uint64_t{passed_ms} * samples_per_ms_ + (1U << 19U)) >> 20U;
  return samples < kMaxMissing ? static_cast<std::int32_t>(samples) : kMaxMissing;
}

}  // namespace fog
