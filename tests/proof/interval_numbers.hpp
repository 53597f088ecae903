#pragma once

#include <cstdint>

#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/play.hpp"
#include "proof/interval.hpp"

namespace fog::proof {

/// All values that a word of the model table may have.
struct ConstantRange {
  std::int64_t low = 0;
  std::int64_t high = 0;

  friend bool operator>(ConstantRange a, std::int64_t b) {
    return a.low > b || (a.high > b && run().decide());
  }
  friend bool operator>(ConstantRange a, ConstantRange b) {
    return a.low > b.high || (a.high > b.low && run().decide());
  }
};

/// The effects' number types over intervals; see fog::BoardNumbers, whose formats these are.
struct IntervalNumbers {
  template <class Fixed>
  using IntervalOf = Interval<typename Fixed::Raw, Fixed::fractional_bits>;

  using Rate = IntervalOf<BoardNumbers::Rate>;
  using Temperature = IntervalOf<BoardNumbers::Temperature>;
  using TemperatureRate = IntervalOf<BoardNumbers::TemperatureRate>;
  using Regressor = IntervalOf<BoardNumbers::Regressor>;
  using Elapsed = IntervalOf<BoardNumbers::Elapsed>;
  using Coefficient = IntervalOf<BoardNumbers::Coefficient>;
  using ScaleFactorError = IntervalOf<BoardNumbers::ScaleFactorError>;
  using RateDrift = IntervalOf<BoardNumbers::RateDrift>;
  template <int kFractionalBits>
  using Number = Interval<std::int32_t, kFractionalBits>;
  template <int kFractionalBits>
  using Wide = Interval<std::int64_t, kFractionalBits>;

  struct RateWithin {};
  struct PowerOn {};
  static Elapsed since(PowerOn /*start*/, Elapsed now) { return now; }
  static Number<30> from_cold(PowerOn /*start*/, Number<31> /*per_tau*/, Number<30> decay) {
    return decay;
  }

  using Constant = ConstantRange;
  template <int kFractionalBits>
  static Number<kFractionalBits> number(Constant constant) {
    return Number<kFractionalBits>::within(constant.low, constant.high);
  }
  // An order: constants() makes a range of one value of it.
  static std::int32_t integer(Constant constant) {
    if (constant.low != constant.high) run().report("an integer with more than one value");
    return static_cast<std::int32_t>(constant.low);
  }

  template <class Value>
  static Value saturating_difference(const Value& a, const Value& b) {
    return saturate_to<Value>(
        Wide<Value::fractional_bits>::within(a.low() - b.high(), a.high() - b.low()));
  }

  // Functions are monotonic within their error, so their values at both ends are their bounds, but
  // for that error (sweep/core_functions.hpp), here in LSB, rounded up.
  static Number<30> logistic(const Number<27>& x) {
    constexpr int kError = 3;
    return Number<30>::checked(fog::logistic(fixed(x.low(), x)).raw() - kError,
                               fog::logistic(fixed(x.high(), x)).raw() + kError, "logistic");
  }
  static Number<30> exponential_decay(const Number<26>& x) {  // never rises
    return Number<30>::checked(fog::exponential_decay(fixed(x.high(), x)).raw(),
                               fog::exponential_decay(fixed(x.low(), x)).raw(), "exponential");
  }
  template <int kFractionalBits>
  static Number<26> natural_logarithm(const Wide<kFractionalBits>& x) {
    constexpr int kError = 1;
    if (x.low() <= 0 && !run().excluded()) run().report("logarithm of what is not positive");
    const auto at = [](Int128 raw) {
      return fog::natural_logarithm(static_cast<std::int64_t>(raw > 0 ? raw : 1), kFractionalBits)
          .raw();
    };
    return Number<26>::checked(Int128{at(x.low())} - kError, Int128{at(x.high())} + kError,
                               "logarithm");
  }
  struct SineCosine {
    Number<30> sine;
    Number<30> cosine;
  };
  template <int kFractionalBits>
  static SineCosine sine_cosine_of_turns(const Wide<kFractionalBits>& /*turns*/) {
    static_assert(kFractionalBits >= 32);
    constexpr int kMax = (1 << 30) + 5;
    return {Number<30>::within(-kMax, kMax), Number<30>::within(-kMax, kMax)};
  }

  /// Its contract: a part of at most the whole gives less than 1.
  class ShareOf {
   public:
    explicit ShareOf(const Rate& whole) : whole_(whole) {}
    Number<31> operator()(const Rate& part) const {
      if (part.high() > whole_.high() || part.low() < -whole_.high()) {
        run().report("share of more than the whole");
      }
      return Number<31>::any();
    }

   private:
    Rate whole_;
  };

 private:
  template <int kFractionalBits>
  static Fixed<std::int32_t, kFractionalBits> fixed(Int128 raw,
                                                    const Number<kFractionalBits>& /*format*/) {
    return Fixed<std::int32_t, kFractionalBits>::from_raw(static_cast<std::int32_t>(raw));
  }
};

}  // namespace fog::proof

namespace fog {

/// Over intervals a lag is its bound: y stays within all its inputs so far, but for kExcess.
///
/// Lemma, for y + round(round22(x - y) * decay) with 0 <= decay < 1, if x <= M. Where y <= M, the
/// rounded difference is below M - y + 2^-23, so the new y is below M + 2^-23 + 2^-41. Where M < y
/// <= M + kExcess, the difference is at most 0 and y does not rise. The same holds from below,
/// where halves are rounded up, too: the difference is at least M - y - 2^-23. lag_lemma.sh has it
/// proved. The test LagStaysWithinItsInputs tries it on the board's lag, at both ends.
template <>
class FirstOrderLag<proof::IntervalNumbers> {
 public:
  using State = proof::IntervalNumbers::Wide<40>;
  using Decay = proof::IntervalNumbers::Number<31>;
  static constexpr std::int64_t kExcess =
      (std::int64_t{1} << 17) + 1;  // 2^-23 + 2^-40, LSB of State

  explicit FirstOrderLag(const Decay& decay) {
    if (decay.low() < 0) proof::run().report("decay below 0");
  }

  void reset(const State& x) { y_ = x; }
  State step(const State& x) {
    const State before = y_;
    y_ = State::checked(std::min(x.low(), y_.low()), std::max(x.high(), y_.high()), "lag");
    const auto difference = saturate_to<proof::IntervalNumbers::Number<22>>(x - before);
    round_to<State>(difference * Decay::any());
    return value();
  }
  State value() const { return State::checked(y_.low() - kExcess, y_.high() + kExcess, "lag"); }

 private:
  State y_;
};

}  // namespace fog
