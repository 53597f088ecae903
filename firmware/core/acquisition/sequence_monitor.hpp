#pragma once

#include <cstdint>

#include "core/signal/status.hpp"

namespace fog {

/// Follows the sequence numbers of the samples, so that the pipeline knows how much time passed.
class SequenceMonitor {
 public:
  struct Verdict {
    Status status = Status::none;
    std::uint32_t missing = 0;  ///< samples lost just before this one: time that passed
    bool late = false;          ///< repeated or out of order: no time passed
  };

  /// So many late samples in a row are a demodulator that started counting anew.
  static constexpr std::uint32_t kLateSamplesOfARestart = 8;

  Verdict judge(std::uint16_t sequence);

 private:
  bool first_ = true;
  std::uint16_t newest_ = 0;
  std::uint32_t late_samples_ = 0;  // in a row
};

}  // namespace fog
