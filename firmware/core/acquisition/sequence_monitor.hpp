#pragma once

#include <cstdint>

#include "core/acquisition/sample_time.hpp"
#include "core/bytes/state_carrier.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Follows the sequence numbers of the samples, so that the pipeline knows how much time passed.
/// They have 16 bits: where a clock is known it says how often they went round, and whether the
/// demodulator has started counting anew.
class SequenceMonitor {
 public:
  struct Verdict {
    Status status = Status::none;
    std::uint32_t missing = 0;  ///< samples lost just before this one: time that passed; <= 2^30
    bool late = false;          ///< repeated or out of order: no time passed
  };

  /// So many late samples in a row are a demodulator that started counting anew.
  static constexpr std::uint32_t kLateSamplesOfARestart = 8;

  /// `sample_period_us` >= 1; it does not matter where no time is known.
  explicit SequenceMonitor(std::uint32_t sample_period_us = 1);

  Verdict judge(std::uint16_t sequence, SampleTime now = {});

  /// After a first sample. What is read back has no time: the sequence alone says how much has
  /// passed since.
  void carry(StateCarrier& state) {
    state(newest_);
    first_ = false;
  }
  /// Where a clock says so all the same: when the newest sample that was read back came.
  void newest_came(SampleTime then) { newest_time_ = then; }

 private:
  std::int32_t samples_in(std::uint32_t passed_ms) const;

  std::uint32_t samples_per_ms_;  // * 2^20
  bool first_ = true;
  std::uint32_t newest_ = 0;  // 16 bits
  SampleTime newest_time_;
  std::uint32_t late_samples_ = 0;  // in a row
};

}  // namespace fog
