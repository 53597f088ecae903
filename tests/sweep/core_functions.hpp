#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/share.hpp"
#include "core/fixed_point/shift.hpp"
#include "core/fixed_point/sine.hpp"
#include "core/frames/rate_float.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermometer/platinum.hpp"

namespace fog::test {

// Every function of the core that has one argument of 32 bits, against the real function that it
// approximates. bench/core_functions.cpp sweeps all arguments, unit/core/core_functions_test.cpp
// a sample. Both hold them to the error that the headers and spec/arithmetic.md promise.

/// What a sweep has found.
struct Worst {
  long double error = 0;
  std::int64_t at = 0;
  long double largest_fall = 0;  ///< from one argument to the next

  void join(const Worst& other) {
    if (other.error > error) {
      error = other.error;
      at = other.at;
    }
    if (other.largest_fall > largest_fall) largest_fall = other.largest_fall;
  }
};

struct CoreFunction {
  const char* name;
  std::int64_t first;  ///< its arguments, raw
  std::int64_t last;
  long double max_error;  ///< as documented
  const char* unit;
  long double max_fall;  ///< as documented; infinity: not monotonic
  /// Arguments `first` to `last` in steps of `stride`.
  Worst (*sweep)(std::int64_t first, std::int64_t last, std::int64_t stride);
};

namespace detail {

// The real function at `first`, `first` + 1 ... as a parabola through three of its values in long
// double: for a smooth one of 256 arguments it is off by less than a ten thousandth of any error
// here.
class Parabola {
 public:
  static constexpr std::int64_t kArguments = 256;

  template <class Function>
  static Parabola of(std::int64_t first) {
    constexpr auto kHalf = kArguments / 2;
    const long double at_first = Function::template exact<long double>(first);
    const long double middle = Function::template exact<long double>(first + kHalf);
    const long double end = Function::template exact<long double>(first + kArguments);
    Parabola parabola;
    parabola.constant_ = static_cast<double>(at_first);
    parabola.slope_ = static_cast<double>((4 * middle - 3 * at_first - end) / kArguments);
    parabola.curvature_ =
        static_cast<double>(2 * (end - 2 * middle + at_first) / (kArguments * kArguments));
    return parabola;
  }
  double operator()(std::int64_t offset) const {
    const auto x = static_cast<double>(offset);
    return constant_ + x * (slope_ + x * curvature_);
  }

 private:
  double constant_ = 0;
  double slope_ = 0;
  double curvature_ = 0;
};

// The double reference only tells where long double could find a new worst error.
template <class Function>
class Sweep {
 public:
  static Worst run(std::int64_t first, std::int64_t last, std::int64_t stride) {
    Sweep sweep(first);
    std::int64_t at = first;
    while (at <= last) {
      if (stride == 1 && at >= Function::kSmoothFrom && last - at >= Parabola::kArguments) {
        const Parabola exact = Parabola::of<Function>(at);
        for (std::int64_t i = 0; i < Parabola::kArguments; ++i) sweep.take(at + i, exact(i));
        at += Parabola::kArguments;
      } else {
        sweep.take(at, Function::template exact<double>(at));
        at += stride;
      }
    }
    return sweep.worst_;
  }

 private:
  explicit Sweep(std::int64_t first) : previous_(Function::value(first)) {}

  void take(std::int64_t at, double exact) {
    constexpr double kMargin = 1e-3;
    const double value = Function::value(at);
    if (previous_ - value > fall_) {
      fall_ = previous_ - value;
      worst_.largest_fall = static_cast<decltype(worst_.largest_fall)>(fall_);
    }
    previous_ = value;
    const double scale = Function::scale(value);
    if (std::abs(value - exact) * scale <= candidate_) return;
    const long double error =
        std::abs(static_cast<long double>(value) - Function::template exact<long double>(at)) *
        static_cast<long double>(scale);
    if (error <= worst_.error) return;
    worst_.error = error;
    worst_.at = at;
    candidate_ = static_cast<double>(error) * (1 - kMargin);
  }

  Worst worst_;
  double previous_;
  double fall_ = 0;
  double candidate_ = 0;
};

template <class Real>
constexpr Real kPi = static_cast<Real>(3.14159265358979323846264338327950288L);

template <int kFraction, class Raw>
double real(Raw raw) {
  return static_cast<double>(raw) * (1.0 / static_cast<double>(std::int64_t{1} << kFraction));
}

// Its error counts as it is.
struct Absolute {
  static constexpr std::int64_t kSmoothFrom = INT64_MIN;  // a parabola describes it from here on
  static double scale(double /*value*/) { return 1; }
};

struct Sine : Absolute {
  static double value(std::int64_t phase) {
    return real<30>(sine_cosine(static_cast<std::uint32_t>(phase)).sine.raw());
  }
  template <class Real>
  static Real exact(std::int64_t phase) {
    return std::sin(std::ldexp(static_cast<Real>(phase), -31) * kPi<Real>);
  }
};

struct Cosine : Absolute {
  static double value(std::int64_t phase) {
    return real<30>(sine_cosine(static_cast<std::uint32_t>(phase)).cosine.raw());
  }
  template <class Real>
  static Real exact(std::int64_t phase) {
    return std::cos(std::ldexp(static_cast<Real>(phase), -31) * kPi<Real>);
  }
};

struct Exponential : Absolute {
  static constexpr std::int64_t kSmoothFrom = 0;
  static double value(std::int64_t raw) {
    const auto x = Fixed<std::int32_t, 26>::from_raw(static_cast<std::int32_t>(raw));
    return -real<30>(exponential_decay(x).raw());  // negative: a function that must not fall
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return raw < 0 ? Real{-1} : -std::exp(-std::ldexp(static_cast<Real>(raw), -26));
  }
};

struct Logarithm : Absolute {
  static constexpr std::int64_t kSmoothFrom = 1 << 22;
  static double value(std::int64_t raw) { return real<26>(natural_logarithm(raw, 16).raw()); }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return std::log(std::ldexp(static_cast<Real>(raw), -16));
  }
};

struct Logistic : Absolute {
  static double value(std::int64_t raw) {
    return real<30>(logistic(ActivationInput::from_raw(static_cast<std::int32_t>(raw))).raw());
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return 1 / (1 + std::exp(-std::ldexp(static_cast<Real>(raw), -27)));
  }
};

struct Tanh : Absolute {
  static double value(std::int64_t raw) {
    const auto x = ActivationInput::from_raw(static_cast<std::int32_t>(raw));
    return real<30>(hyperbolic_tangent(x).raw());
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return std::tanh(std::ldexp(static_cast<Real>(raw), -27));
  }
};

// A network's layer makes places of 32-bit sums; those of a layer with a shift are among these, or
// beyond the last node.
struct Activation : Absolute {
  static double value(std::int64_t raw) {
    return real<30>(symmetric_logistic(NodePlace::from_raw(raw * 256)).raw());
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return std::tanh(std::ldexp(static_cast<Real>(raw), -28));
  }
};

// Beyond the last nodes: the argument is the lower word, the signed distance, which is arbitrary
// there.
template <std::int32_t kNode>
struct ActivationBeyond : Absolute {
  static double value(std::int64_t raw) {
    return real<30>(
        symmetric_logistic(NodePlace::from_raw(std::int64_t{kNode} * 4294967296 + raw)).raw());
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return std::tanh(std::ldexp(static_cast<Real>(raw), -36) + static_cast<Real>(kNode) / 16);
  }
};

struct Platinum : Absolute {
  static constexpr std::int64_t kSmoothFrom = INT64_MAX;
  static double value(std::int64_t raw) {
    const auto ratio = ResistanceRatio::from_raw(static_cast<std::int32_t>(raw));
    return real<16>(platinum_temperature(ratio).raw());
  }
  // The standard's polynomial, solved by Newton from the core's answer.
  template <class Real>
  static Real exact(std::int64_t raw) {
    const Real a = static_cast<Real>(3.9083e-3L);
    const Real b = static_cast<Real>(-5.775e-7L);
    const Real ratio = std::ldexp(static_cast<Real>(raw), -28);
    Real t = static_cast<Real>(value(raw));
    const Real c = t < 0 ? static_cast<Real>(-4.183e-12L) : Real{0};
    for (int step = 0; step < 2; ++step) {
      const Real of_t = 1 + t * (a + t * (b + c * t * (t - 100)));
      const Real slope = a + 2 * b * t + c * t * t * (4 * t - 300);
      t += (ratio - of_t) / slope;
    }
    return t;
  }
};

// In units in the last place of the float.
struct RateFloat {
  static constexpr std::int64_t kSmoothFrom = INT64_MAX;
  static double value(std::int64_t raw) {
    const std::uint32_t bits =
        rate_as_radians_float(Rate::from_raw(static_cast<std::int32_t>(raw)));
    const auto exponent = static_cast<int>(bits >> 23U & 255U);
    const double mantissa =
        bits << 1U == 0 ? 0 : static_cast<double>((bits & 0x7FFFFFU) | 0x800000U);
    return std::ldexp(bits >> 31U != 0 ? -mantissa : mantissa, exponent - 150);
  }
  static double scale(double value) {
    return value == 0 ? 1 : std::ldexp(1.0, 23 - std::ilogb(value));
  }
  template <class Real>
  static Real exact(std::int64_t raw) {
    return std::ldexp(static_cast<Real>(raw), -10) * (kPi<Real> / 648000);
  }
};

// In LSB: of each whole the share of one part, which covers all sizes and both signs.
struct Reciprocal {
  static constexpr std::int64_t kSmoothFrom = INT64_MAX;
  static std::int32_t part_of(std::int64_t whole) {
    const std::uint64_t mixed = static_cast<std::uint64_t>(whole) * 0x9E3779B97F4A7C15U >> 20U;
    const auto magnitude = static_cast<std::int64_t>(mixed % static_cast<std::uint64_t>(whole + 1));
    return static_cast<std::int32_t>((mixed & 1U << 30U) != 0 ? -magnitude : magnitude);
  }
  static double value(std::int64_t whole) {
    using Raw = Fixed<std::int32_t, 0>;
    const ShareOf share(Raw::from_raw(static_cast<std::int32_t>(whole)));
    return real<31>(share(Raw::from_raw(part_of(whole))).raw());
  }
  static double scale(double /*value*/) { return 2147483648.0; }
  template <class Real>
  static Real exact(std::int64_t whole) {
    return static_cast<Real>(part_of(whole)) / static_cast<Real>(whole);
  }
};

// 1 where a quotient is wrong: of a numerator that is as good as drawn, and of the one below a
// multiple.
struct Division : Absolute {
  static constexpr std::int64_t kSmoothFrom = INT64_MAX;
  static double value(std::int64_t raw) {
    const auto denominator = static_cast<std::uint32_t>(raw);
    const std::uint64_t mixed = 0x9E3779B97F4A7C15U * (denominator | 1U);
    const std::uint64_t whole = mixed / denominator * denominator;
    const bool right = divide(mixed, denominator) == mixed / denominator &&
                       divide(whole - 1, denominator) == (whole - 1) / denominator;
    return right ? 0 : 1;
  }
  template <class Real>
  static Real exact(std::int64_t /*raw*/) {
    return 0;
  }
};

// 1 where a shift rounds otherwise than (value + half) / 2^bits, rounded down.
struct RoundShift : Absolute {
  static constexpr std::int64_t kSmoothFrom = INT64_MAX;
  static double value(std::int64_t raw) {
    bool wrong = false;
    for (int bits = 1; bits < 32; ++bits) {
      const std::int64_t exact = (raw + (std::int64_t{1} << (bits - 1))) >> bits;
      wrong |= round_shift(static_cast<std::int32_t>(raw), bits) != exact;
    }
    return wrong ? 1 : 0;
  }
  template <class Real>
  static Real exact(std::int64_t /*raw*/) {
    return 0;
  }
};

}  // namespace detail

constexpr long double kNotMonotonic = HUGE_VALL;
constexpr std::int64_t kRatioOfPlatinumFrom = 161748039;  // -100 degC
constexpr std::int64_t kRatioOfPlatinumTo = 472059856;    // 200 degC

inline const std::array<CoreFunction, 15>& core_functions() {
  static const std::array<CoreFunction, 15> all{{
      {"sine", 0, UINT32_MAX, 4.32e-9L, "", kNotMonotonic, detail::Sweep<detail::Sine>::run},
      {"cosine", 0, UINT32_MAX, 4.32e-9L, "", kNotMonotonic, detail::Sweep<detail::Cosine>::run},
      {"exponential", INT32_MIN, INT32_MAX, 1.54e-9L, "", 0,
       detail::Sweep<detail::Exponential>::run},
      {"logarithm", 1, UINT32_MAX, 8.98e-9L, "", kNotMonotonic,
       detail::Sweep<detail::Logarithm>::run},
      {"logistic", INT32_MIN, INT32_MAX, 2.51e-9L, "", 9.32e-10L,
       detail::Sweep<detail::Logistic>::run},
      {"tanh, up to 8", -(std::int64_t{1} << 30), std::int64_t{1} << 30, 5e-9L, "", kNotMonotonic,
       detail::Sweep<detail::Tanh>::run},
      {"tanh, beyond", (std::int64_t{1} << 30) + 1, INT32_MAX, 2.27e-7L, "", kNotMonotonic,
       detail::Sweep<detail::Tanh>::run},
      {"activation, up to 16", INT32_MIN, INT32_MAX, 1.8e-7L, "", kNotMonotonic,
       detail::Sweep<detail::Activation>::run},
      {"activation, above 16", INT32_MIN, INT32_MAX, 2.72e-7L, "", kNotMonotonic,
       detail::Sweep<detail::ActivationBeyond<1000>>::run},
      {"activation, below -16", INT32_MIN, INT32_MAX, 2.72e-7L, "", kNotMonotonic,
       detail::Sweep<detail::ActivationBeyond<-1000>>::run},
      {"platinum temperature", kRatioOfPlatinumFrom, kRatioOfPlatinumTo, 2.63e-5L, "degC", 1.53e-5L,
       detail::Sweep<detail::Platinum>::run},
      {"rate as a float", INT32_MIN, INT32_MAX, 0.501L, "units in the last place", 0,
       detail::Sweep<detail::RateFloat>::run},
      {"share of a whole", 1, INT32_MAX, 2.98L, "LSB", kNotMonotonic,
       detail::Sweep<detail::Reciprocal>::run},
      {"division", 1, UINT32_MAX, 0, "wrong", kNotMonotonic, detail::Sweep<detail::Division>::run},
      {"rounding shift", INT32_MIN, INT32_MAX, 0, "wrong", kNotMonotonic,
       detail::Sweep<detail::RoundShift>::run},
  }};
  return all;
}

}  // namespace fog::test
