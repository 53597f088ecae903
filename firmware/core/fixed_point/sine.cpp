#include "core/fixed_point/sine.hpp"

#include "core/fixed_point/sine_table.hpp"

namespace fog {
namespace {

using Value = Fixed<std::int32_t, 30>;

constexpr int kNodeBits = 6;  // nodes every 1/64 turn
constexpr unsigned kQuarter = 16;
constexpr unsigned kHalf = 32;

// The test "SineTable" recomputes these.
constexpr auto kRadiansPerTurn = Fixed<std::int32_t, 28>::from_raw(1686629713);
constexpr auto kSixth = Value::from_raw(178956971);
constexpr auto kTwentyFourth = Value::from_raw(44739243);

Value sine_at(unsigned node) {
  const unsigned in_half = node % kHalf;
  const unsigned in_quarter = in_half <= kQuarter ? in_half : kHalf - in_half;
  const auto value = Value::from_raw(kSineTable[in_quarter]);
  return (node & kHalf) != 0U ? -value : value;
}

}  // namespace

// sin(a + d) and cos(a + d) from the nearest node a. |d| <= 1/128 turn = 0.0491, so the first
// neglected terms are d^5/120 = 2.4e-9 of sin d and d^6/720 = 2e-11 of cos d.
SineCosine sine_cosine(std::uint32_t phase) {
  constexpr unsigned kDropped = 32 - kNodeBits;
  constexpr auto kOne = from_integer<Value>(1);
  constexpr auto kOneHalf = Value::from_raw(kOne.raw() / 2);
  const auto product = [](auto a, auto b) { return round_to<Value>(a * b); };

  const std::uint32_t node = (phase + (1U << (kDropped - 1U))) >> kDropped;  // wraps at a turn
  const auto turns = Fixed<std::int32_t, 31>::from_raw(
      static_cast<std::int32_t>(phase - (node << kDropped)));  // twice the distance
  const auto distance = round_to<Value>(divide_by_power_of_two<1>(turns * kRadiansPerTurn));
  const Value square = product(distance, distance);
  const Value cosine = kOne - product(square, kOneHalf - product(square, kTwentyFourth));
  const Value sine = distance - product(distance, product(square, kSixth));
  const Value node_sine = sine_at(node);
  const Value node_cosine = sine_at(node + kQuarter);
  return {product(node_sine, cosine) + product(node_cosine, sine),
          product(node_cosine, cosine) - product(node_sine, sine)};
}

}  // namespace fog
