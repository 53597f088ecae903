#pragma once

#include <cstdint>
#include <type_traits>

#include "core/fixed_point/shift.hpp"

namespace fog {

/// Mean of the good values of a block; Value is a 32-bit Fixed. The sum is exact: a block has at
/// most 2^31 - 1 samples.
template <class Value>
class BlockAverage {
  static_assert(std::is_same_v<typename Value::Raw, std::int32_t>);
  static_assert(-std::int64_t{INT32_MIN} * INT32_MAX <= kMaxDividend);

 public:
  void add(Value value) {
    sum_ += value.raw();
    ++count_;
  }

  bool empty() const { return count_ == 0; }

  /// Mean, halves upwards. Not for an empty block.
  Value mean() const {
    return Value::from_raw(static_cast<std::int32_t>(round_divide(sum_, count_)));
  }

  void clear() { *this = BlockAverage(); }

 private:
  std::int64_t sum_ = 0;
  std::int32_t count_ = 0;
};

}  // namespace fog
