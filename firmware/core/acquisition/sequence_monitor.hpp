#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/bytes/state_carrier.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Follows the 16-bit sequence numbers, so that the pipeline knows how much time has passed. With a
/// clock it also finds whole turns of the numbers and a restart of the demodulator's count.
class SequenceMonitor {
 public:
  struct Verdict {
    Status status = Status::none;
    std::uint32_t missing = 0;  ///< samples lost just before this one: time that passed; <= 2^30
    bool late = false;          ///< repeated or out of order: no time passed
  };

  /// Consecutive late samples that mean that the demodulator has restarted its count.
  static constexpr std::uint32_t kLateSamplesForRestart = 8;

  /// `sample_period_us` >= 1; unused without a clock.
  explicit SequenceMonitor(std::uint32_t sample_period_us = 1);

  Verdict judge(std::uint16_t sequence, SampleTime now = {});

  /// To be called after a first sample. State that is read back has no time: the time passed since
  /// then follows from the sequence numbers alone.
  void carry(StateCarrier& state) {
    state(newest_);
    first_ = false;
  }
  /// Sets the arrival time of the newest sample that was read back, if a clock has outlasted the
  /// reset.
  void set_newest_time(SampleTime then) { newest_time_ = then; }

 private:
  std::int32_t samples_in(std::uint32_t passed_ms) const;

  std::uint32_t samples_per_ms_;  // * 2^20
  bool first_ = true;
  std::uint32_t newest_ = 0;  // 16 bits
  SampleTime newest_time_;
  std::uint32_t late_samples_ = 0;  // consecutive
};

}  // namespace fog
