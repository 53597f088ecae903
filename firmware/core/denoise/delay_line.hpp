#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/span.hpp"

namespace fog {

/// Gives back what was put in `length` calls ago, in memory that somebody else owns.
class DelayLine {
 public:
  DelayLine() = default;
  explicit DelayLine(Span<std::int32_t> memory) : memory_(memory) {}

  void fill(std::int32_t value) {
    for (std::int32_t& slot : memory_) slot = value;
  }

  std::int32_t exchange(std::int32_t value) {
    if (memory_.size == 0) return value;
    const std::int32_t oldest = memory_[next_];
    memory_[next_] = value;
    next_ = next_ + 1 == memory_.size ? 0 : next_ + 1;
    return oldest;
  }

 private:
  Span<std::int32_t> memory_;
  std::size_t next_ = 0;
};

}  // namespace fog
