#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/bytes/state_carrier.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Follows the 16-bit sequence numbers, so that the pipeline knows how much time has passed. With a
/// clock it also finds whole turns of the numbers and a restart of the demodulator's count. Without
/// one a gap may be a leap of the numbers alone: more than kDoubtUs of them is doubtful.
class SequenceMonitor {
 public:
  struct Verdict {
    Status status = Status::none;
    std::uint32_t missing = 0;  ///< samples lost just before this one: time that passed; <= 2^30
    bool late = false;          ///< repeated or out of order: no time passed
    bool doubtful = false;      ///< nobody can say how much time has passed lately
  };

  /// Consecutive late samples that mean that the demodulator has restarted its count.
  static constexpr std::uint32_t kLateSamplesForRestart = 8;

  /// `sample_period_us` >= 1.
  explicit SequenceMonitor(std::uint32_t sample_period_us = 1);

  Verdict judge(std::uint16_t sequence, SampleTime now = {});

  /// To be called after a first sample. State that is read back has no time: the time passed since
  /// then follows from the sequence numbers alone. They are believed up to the time that a restart
  /// can take.
  void carry(StateCarrier& state) {
    state(newest_);
    first_ = false;
    if (state.restores()) doubt_ = -kRestarts * max_doubt_;
  }
  /// Sets the arrival time of the newest sample that was read back, if a clock has outlasted the
  /// reset.
  void set_newest_time(SampleTime then) { newest_time_ = then; }

 private:
  // Samples that are said to be lost count as one in 50 of the time that has to pass until they do
  // not matter: a sample rate may be off by as much (SampleRateMonitor). A fifth of a second makes
  // 0.01 degC/min at 3 degC/min behind lags of 30 s.
  static constexpr std::int32_t kDoubtPerSample = 50;
  static constexpr std::uint32_t kDoubtUs = 10'000'000;
  static constexpr std::int32_t kRestarts = 10;  // 2 s, in kDoubtUs / kDoubtPerSample

  std::int32_t samples_in(std::uint32_t passed_ms) const;
  bool is_doubtful(std::uint32_t missing);

  std::uint32_t samples_per_ms_;  // * 2^20
  std::int32_t max_doubt_;        // samples in kDoubtUs
  bool first_ = true;
  std::uint32_t newest_ = 0;  // 16 bits
  SampleTime newest_time_;
  std::uint32_t late_samples_ = 0;  // consecutive
  std::int32_t doubt_ = 0;  // kDoubtPerSample for each lost one, one less with each that came
};

}  // namespace fog
