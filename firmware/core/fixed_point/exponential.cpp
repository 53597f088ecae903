#include "core/fixed_point/exponential.hpp"

#include "core/fixed_point/exponential_table.hpp"

namespace fog {
namespace {

using Value = Fixed<std::int32_t, 30>;

constexpr int kNodeBits = 4;  // nodes every 1/16 of a halving
constexpr std::int64_t kNodes = 1 << kNodeBits;

// The test "ExponentialTable" recomputes these.
constexpr auto kLog2OfE = Value::from_raw(1549082005);
constexpr auto kLogOf2 = Fixed<std::int32_t, 31>::from_raw(1488522236);
constexpr auto kSixth = Value::from_raw(178956971);
constexpr auto kTwentyFourth = Value::from_raw(44739243);

}  // namespace

// exp(-x) = 2^-y with y = x log2 e = halvings + node/16 + d: a shift, a table and a series in
// z = d ln 2. |d| <= 1/32, so |z| <= 0.0217 and the first neglected term is z^5/120 = 4e-11.
Value exponential_decay(Fixed<std::int32_t, 26> x) {
  constexpr auto kOne = from_integer<Value>(1);
  constexpr auto kOneHalf = Value::from_raw(kOne.raw() / 2);
  const auto product = [](auto a, auto b) { return round_to<Value>(a * b); };
  if (x < Fixed<std::int32_t, 26>{}) return kOne;

  // x < 32, so y < 46.2.
  static_assert(INT32_MAX * std::int64_t{kLog2OfE.raw()} < std::int64_t{1} << 62);
  const std::int64_t y = round_to<Fixed<std::int64_t, 32>>(x * kLog2OfE).raw();
  const std::int64_t nodes = round_shift(y, 32 - kNodeBits);
  const auto distance = Fixed<std::int32_t, 31>::from_raw(
      static_cast<std::int32_t>(y - shift_left(nodes, 32 - kNodeBits)));  // 2 d
  const auto z = round_to<Value>(divide_by_power_of_two<1>(distance * kLogOf2));
  Value series = kSixth - product(z, kTwentyFourth);
  series = kOneHalf - product(z, series);
  series = kOne - product(z, series);
  series = kOne - product(z, series);
  const Value fraction = product(Value::from_raw(kExponentialTable[nodes % kNodes]), series);
  const auto halvings = static_cast<int>(nodes / kNodes);
  constexpr int kMaxHalvings = 31;  // beyond it 2^30 is shifted to 0
  return halvings > kMaxHalvings ? Value{} : Value::from_raw(round_shift(fraction.raw(), halvings));
}

}  // namespace fog
