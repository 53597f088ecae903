#pragma once

#include <cstdint>

#include "core/fixed_point/shift.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Mean temperature of the valid samples of a block. The sum is exact: 2^31 * 2^31 fits 64 bits,
/// and a block has at most 2^31 - 1 samples.
class BlockAverage {
 public:
  void add(Temperature temperature) {
    sum_ += temperature.raw();
    ++count_;
  }

  bool empty() const { return count_ == 0; }

  /// Mean, halves upwards. Not for an empty block.
  Temperature mean() const {
    return Temperature::from_raw(static_cast<std::int32_t>(round_divide(sum_, count_)));
  }

  void clear() { *this = BlockAverage(); }

 private:
  std::int64_t sum_ = 0;
  std::int32_t count_ = 0;
};

}  // namespace fog
