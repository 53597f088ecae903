#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

/// Fractions of a constant whole: one division in the constructor, then products.
class ShareOf {
 public:
  /// `whole` > 0; other values count as one LSB.
  template <int kBits>
  explicit ShareOf(Fixed<std::int32_t, kBits> whole) : ShareOf(whole.raw() > 0 ? whole.raw() : 1) {}

  /// part / whole, rounded down, for |part| <= whole in the format of whole; 1 itself gives the
  /// highest value below it. Error below 3 LSB: the inverse has 31 significant bits.
  template <int kBits>
  Fixed<std::int32_t, 31> operator()(Fixed<std::int32_t, kBits> part) const {
    const auto scaled = static_cast<std::int32_t>(static_cast<std::uint32_t>(part.raw()) << shift_);
    return Fixed<std::int32_t, 31>::from_raw(
        static_cast<std::int32_t>(floor_shift(std::int64_t{scaled} * inverse_, kInverseLog2 - 31)));
  }

 private:
  static constexpr int kInverseLog2 = 61;

  // Inverse of the scaled whole, 2^30 to 2^31 - 1: rounded down, so that no fraction reaches 1.
  explicit ShareOf(std::int32_t whole)
      : shift_(__builtin_clz(static_cast<std::uint32_t>(whole)) - 1),
        inverse_(static_cast<std::int32_t>(divide(power_of_two<std::uint64_t>(kInverseLog2) - 1,
                                                  static_cast<std::uint32_t>(whole) << shift_))) {}

  int shift_;
  std::int32_t inverse_;
};

}  // namespace fog
