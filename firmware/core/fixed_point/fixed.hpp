#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/fixed_point/overflow.hpp"
#include "core/fixed_point/shift.hpp"

namespace fog {

/// A real number stored as raw * 2^-fractional_bits. The format is part of the type, so that a
/// shift can be neither forgotten nor done twice:
///  * sums need equal formats; a product has the sum of both fractions and is exact;
///  * only round_to<To>(), floor_to<To>() and saturate_to<To>() change the format;
///  * results of + - and round_to must fit (checked builds report overflow); saturate_to clips.
template <typename RawType, int kFractionalBits>
class Fixed {
 public:
  using Raw = RawType;
  static constexpr int fractional_bits = kFractionalBits;
  static_assert(std::is_same_v<Raw, std::int32_t> || std::is_same_v<Raw, std::int64_t>);
  // Fractions may exceed the bits of Raw: for small numbers, such as the distance to a table node.
  static_assert(kFractionalBits >= 0 && kFractionalBits < 64);

  constexpr Fixed() = default;
  static constexpr Fixed from_raw(Raw raw) {
    Fixed value;
    value.raw_ = raw;
    return value;
  }
  static constexpr Fixed highest() { return from_raw(std::numeric_limits<Raw>::max()); }
  static constexpr Fixed lowest() { return from_raw(std::numeric_limits<Raw>::min()); }

  constexpr Raw raw() const { return raw_; }

  friend constexpr Fixed operator+(Fixed a, Fixed b) {
    Raw sum{};
    check_range(!__builtin_add_overflow(a.raw_, b.raw_, &sum));  // wraps in `sum`
    return from_raw(sum);
  }
  friend constexpr Fixed operator-(Fixed a, Fixed b) {
    Raw difference{};
    check_range(!__builtin_sub_overflow(a.raw_, b.raw_, &difference));
    return from_raw(difference);
  }
  friend constexpr Fixed operator-(Fixed a) { return Fixed() - a; }
  constexpr Fixed& operator+=(Fixed other) { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) { return *this = *this - other; }

  friend constexpr bool operator==(Fixed a, Fixed b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(Fixed a, Fixed b) { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(Fixed a, Fixed b) { return a.raw_ < b.raw_; }
  friend constexpr bool operator>(Fixed a, Fixed b) { return a.raw_ > b.raw_; }
  friend constexpr bool operator<=(Fixed a, Fixed b) { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>=(Fixed a, Fixed b) { return a.raw_ >= b.raw_; }

 private:
  Raw raw_ = 0;
};

/// Exact: 32 x 32 bits give 64. The largest magnitude, lowest * lowest = 2^62, fits as well.
template <int kA, int kB>
constexpr Fixed<std::int64_t, kA + kB> operator*(Fixed<std::int32_t, kA> a,
                                                 Fixed<std::int32_t, kB> b) {
  return Fixed<std::int64_t, kA + kB>::from_raw(std::int64_t{a.raw()} * b.raw());
}

/// The product must fit 64 bits (checked builds report overflow).
template <int kA, int kB>
constexpr Fixed<std::int64_t, kA + kB> operator*(Fixed<std::int64_t, kA> a,
                                                 Fixed<std::int32_t, kB> b) {
  std::int64_t product{};
  check_range(!__builtin_mul_overflow(a.raw(), std::int64_t{b.raw()}, &product));
  return Fixed<std::int64_t, kA + kB>::from_raw(product);
}

/// The upper half of the product, rounded down: one instruction (SMULL). Fits for any pair.
template <int kA, int kB>
constexpr Fixed<std::int32_t, kA + kB - 32> high_product(Fixed<std::int32_t, kA> a,
                                                         Fixed<std::int32_t, kB> b) {
  return Fixed<std::int32_t, kA + kB - 32>::from_raw(
      static_cast<std::int32_t>(floor_shift(std::int64_t{a.raw()} * b.raw(), 32)));
}

/// `value` in the format To, rounded down: a shift, for uses where half an LSB does not matter.
template <class To, int kBits>
constexpr To floor_to(Fixed<std::int32_t, kBits> value) {
  return To::from_raw(floor_shift(value.raw(), kBits - To::fractional_bits));
}

template <typename T>
struct IsFixed : std::false_type {};
template <typename Raw, int kBits>
struct IsFixed<Fixed<Raw, kBits>> : std::true_type {};

namespace detail {

// The raw value with To's fraction, in the wider of the two raw types.
template <class To, class From>
constexpr auto change_fraction(From value) {
  using Wide = std::conditional_t<(sizeof(typename From::Raw) > sizeof(typename To::Raw)),
                                  typename From::Raw, typename To::Raw>;
  constexpr int dropped = From::fractional_bits - To::fractional_bits;
  if constexpr (dropped >= 0) {
    return round_shift(Wide{value.raw()}, dropped);
  } else {
    return shift_left(Wide{value.raw()}, -dropped);
  }
}

}  // namespace detail

// The functions below also accept plain numbers, because the host instantiates the effects with its
// own real type. There a change of format does nothing.

/// The product.
template <class Number, std::enable_if_t<!IsFixed<Number>::value, int> = 0>
constexpr Number high_product(Number a, Number b) {
  return a * b;
}

/// `value` in the format To, rounded by round_shift. It must fit.
template <class To, class From>
constexpr To round_to(From value) {
  if constexpr (IsFixed<From>::value) {
    const auto raw = detail::change_fraction<To>(value);
    check_range(raw <= std::numeric_limits<typename To::Raw>::max() &&
                raw >= std::numeric_limits<typename To::Raw>::min());
    return To::from_raw(static_cast<typename To::Raw>(raw));
  } else {
    return value;
  }
}

/// `value` in the format To, rounded by round_shift, clipped to its range. Where the fraction
/// grows, the value must fit a 64-bit integer in the new format.
template <class To, class From>
constexpr To saturate_to(From value) {
  if constexpr (IsFixed<From>::value) {
    using Wide = Fixed<std::int64_t, From::fractional_bits>;
    const auto raw = detail::change_fraction<Fixed<std::int64_t, To::fractional_bits>>(
        Wide::from_raw(value.raw()));
    return To::from_raw(saturate<typename To::Raw>(raw));
  } else {
    return value;
  }
}

/// A whole number in the format T. It must fit.
template <class T>
constexpr T from_integer(std::int32_t integer) {
  if constexpr (IsFixed<T>::value) {
    return round_to<T>(Fixed<std::int32_t, 0>::from_raw(integer));
  } else {
    return static_cast<T>(integer);
  }
}

/// value / 2^kBits, exact: the same raw number with kBits more fractional bits.
template <int kBits, class T>
constexpr auto divide_by_power_of_two(T value) {
  if constexpr (IsFixed<T>::value) {
    return Fixed<typename T::Raw, T::fractional_bits + kBits>::from_raw(value.raw());
  } else {
    return value / static_cast<T>(std::int64_t{1} << kBits);
  }
}

template <class T>
constexpr T clamp(T value, T min, T max) {
  return value < min ? min : (max < value ? max : value);
}

}  // namespace fog
