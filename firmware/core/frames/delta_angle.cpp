#include "core/frames/delta_angle.hpp"

#include "core/frames/rate_float.hpp"

namespace fog {

void DeltaAngle::step(Rate rate) {
  constexpr int kFraction = 48;
  // |rate| * lower word + fraction_ < 2^31 * 2^32; both parts are exact.
  const std::int64_t raw = rate.raw();
  const std::int64_t lower = raw * static_cast<std::uint32_t>(per_lsb_) + fraction_;
  fraction_ = static_cast<std::uint32_t>(lower);
  angle_ += raw * static_cast<std::int64_t>(per_lsb_ >> 32U) + floor_shift(lower, 32);
  bits_ = 0;
  if (angle_ == 0) return;
  const bool negative = angle_ < 0;
  const auto magnitude = static_cast<std::uint64_t>(negative ? -angle_ : angle_);
  const int top_bit = 63 - __builtin_clzll(magnitude);
  const int dropped = top_bit > kMantissaBits ? top_bit - kMantissaBits : 0;
  const std::uint64_t half = dropped > 0 ? power_of_two<std::uint64_t>(dropped - 1) : 0;
  const std::uint64_t kept = (magnitude + half) >> static_cast<unsigned>(dropped);
  const auto mantissa =
      static_cast<std::uint32_t>(kept << static_cast<unsigned>(kMantissaBits + dropped - top_bit));
  bits_ = assemble_float(negative, top_bit - kFraction, mantissa);
  const auto sent = static_cast<std::int64_t>(kept << static_cast<unsigned>(dropped));
  angle_ += negative ? sent : -sent;
}

}  // namespace fog
