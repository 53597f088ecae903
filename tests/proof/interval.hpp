#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "core/fixed_point/fixed.hpp"

namespace fog::proof {

__extension__ using Int128 = __int128;

/// What a run over intervals has found, and which way it takes where a comparison can go both ways.
/// One run is one path; next_path() tells whether another one is left.
class Run {
 public:
  /// An operation whose result can leave its type, each once.
  void report(const std::string& operation) { reports_.insert(operation); }
  const std::set<std::string>& reports() const { return reports_; }

  bool decide() {
    if (taken_ == decisions_.size()) decisions_.push_back(false);
    return decisions_[taken_++];
  }
  bool next_path() {
    while (!decisions_.empty() && decisions_.back()) decisions_.pop_back();
    taken_ = 0;
    if (decisions_.empty()) return false;
    decisions_.back() = true;
    return true;
  }
  /// The ways that this path took.
  const std::vector<bool>& path() const { return decisions_; }
  /// A path on which no number is left, because two of its comparisons exclude each other.
  void exclude() { excluded_ = true; }
  bool excluded() const { return excluded_; }
  void start_path() { excluded_ = false; }

  /// The bounds of all results since the last call.
  using Trace = std::vector<std::int64_t>;
  void note(Int128 low, Int128 high) {
    trace_.push_back(static_cast<std::int64_t>(low));
    trace_.push_back(static_cast<std::int64_t>(high));
  }
  Trace take_trace() {
    Trace trace;
    trace.swap(trace_);
    return trace;
  }

  std::uint64_t new_value() { return ++values_; }

 private:
  std::set<std::string> reports_;
  std::vector<bool> decisions_;
  std::size_t taken_ = 0;
  bool excluded_ = false;
  Trace trace_;
  std::uint64_t values_ = 0;
};

inline Run& run() {
  static Run run;
  return run;
}

/// All values that a Fixed<Raw, kFractionalBits> can have at a place of the program: a stand-in for
/// it in the templates of the core. Every operation of Fixed is here with the same name; one whose
/// result can leave Raw is reported. A comparison that can go both ways takes both, one a path, and
/// narrows its operands.
///
/// Bounds alone would lose that x - clamp(y, x - r, x + r) is at most r. So a value also knows its
/// distance from the value that it was made of by sums.
template <typename RawType, int kFractionalBits>
class Interval {
 public:
  using Raw = RawType;
  static constexpr int fractional_bits = kFractionalBits;

  constexpr Interval() = default;
  /// A whole number: from_integer().
  explicit constexpr Interval(std::int32_t integer)
      : Interval(Constant(), Int128{integer} * (Int128{1} << kFractionalBits)) {}
  /// Raw bounds.
  static Interval within(Int128 low, Int128 high) {
    Interval interval;
    interval.low_ = low;
    interval.high_ = high;
    interval.origin_ = run().new_value();
    return interval;
  }
  static Interval any() {
    return within(std::numeric_limits<Raw>::min(), std::numeric_limits<Raw>::max());
  }
  static Interval lowest() {
    return within(std::numeric_limits<Raw>::min(), std::numeric_limits<Raw>::min());
  }
  static Interval highest() {
    return within(std::numeric_limits<Raw>::max(), std::numeric_limits<Raw>::max());
  }
  /// The result of `operation`, which has to fit Raw.
  static Interval checked(Int128 low, Int128 high, const char* operation) {
    constexpr Int128 kMin = std::numeric_limits<Raw>::min();
    constexpr Int128 kMax = std::numeric_limits<Raw>::max();
    if ((low < kMin || high > kMax) && !run().excluded()) {
      run().report(std::string(operation) + " to " + std::to_string(8 * sizeof(Raw)) +
                   " bits with " + std::to_string(kFractionalBits) + " of fraction");
    }
    const Interval result = within(std::clamp(low, kMin, kMax), std::clamp(high, kMin, kMax));
    run().note(result.low_, result.high_);
    return result;
  }

  Int128 low() const { return low_; }
  Int128 high() const { return high_; }

  friend Interval operator+(Interval a, Interval b) {
    return checked(a.low_ + b.low_, a.high_ + b.high_, "sum")
        .from(a, a.nearest_ + b.low_, a.farthest_ + b.high_);
  }
  friend Interval operator-(Interval a, Interval b) {
    Int128 low = a.low_ - b.high_;
    Int128 high = a.high_ - b.low_;
    if (a.origin_ == b.origin_) {
      low = std::max(low, a.nearest_ - b.farthest_);
      high = std::min(high, a.farthest_ - b.nearest_);
    }
    return checked(low, high, "difference").from(a, a.nearest_ - b.high_, a.farthest_ - b.low_);
  }
  friend Interval operator-(Interval a) { return Interval() - a; }
  Interval& operator+=(Interval other) { return *this = *this + other; }
  Interval& operator-=(Interval other) { return *this = *this - other; }

  friend bool operator<(const Interval& a, const Interval& b) {
    const bool is = a.high_ < b.low_ || (a.low_ < b.high_ && run().decide());
    if (is) {
      narrow(a, b, 1);
    } else {
      narrow(b, a, 0);
    }
    return is;
  }
  friend bool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend bool operator<=(const Interval& a, const Interval& b) { return !(b < a); }
  friend bool operator>=(const Interval& a, const Interval& b) { return !(a < b); }
  friend bool operator==(const Interval& a, const Interval& b) {
    if (a.low_ == a.high_ && b.low_ == b.high_) return a.low_ == b.low_;
    return a.low_ <= b.high_ && b.low_ <= a.high_ && run().decide();
  }

  friend Interval clamp(const Interval& value, const Interval& min, const Interval& max) {
    Interval held = within(std::max(min.low_, std::min(value.low_, max.low_)),
                           std::max(min.high_, std::min(value.high_, max.high_)));
    run().note(held.low_, held.high_);
    if (min.origin_ == max.origin_) held = held.from(min, min.nearest_, max.farthest_);
    return held;
  }

  bool is_same_value(const Interval& other) const {
    return origin_ == other.origin_ && nearest_ == farthest_ && other.nearest_ == nearest_ &&
           other.farthest_ == nearest_;
  }

 private:
  struct Constant {};
  constexpr Interval(Constant /*known*/, Int128 raw)
      : low_(raw), high_(raw), nearest_(raw), farthest_(raw) {
    if (raw < std::numeric_limits<Raw>::min() || raw > std::numeric_limits<Raw>::max()) {
      run().report("from_integer");
    }
  }

  // The same value, which is `nearest` to `farthest` above the origin of `other`.
  Interval from(const Interval& other, Int128 nearest, Int128 farthest) const {
    Interval result = *this;
    result.origin_ = other.origin_;
    result.nearest_ = nearest;
    result.farthest_ = farthest;
    return result;
  }
  // smaller + distance <= larger is known from here on.
  static void narrow(const Interval& smaller, const Interval& larger, Int128 distance) {
    smaller.high_ = std::min(smaller.high_, larger.high_ - distance);
    larger.low_ = std::max(larger.low_, smaller.low_ + distance);
    if (smaller.low_ > smaller.high_ || larger.low_ > larger.high_) return run().exclude();
    // Their difference is exact only from one of the two.
    smaller.origin_ = run().new_value();
    smaller.nearest_ = smaller.farthest_ = 0;
    larger.origin_ = smaller.origin_;
    larger.nearest_ = distance;
    larger.farthest_ = larger.high_ - smaller.low_;
  }

  // A comparison narrows values that the program only reads.
  mutable Int128 low_ = 0;
  mutable Int128 high_ = 0;
  mutable std::uint64_t origin_ = 0;  // number of the value it was made of; 0: the number 0
  mutable Int128 nearest_ = 0;        // distance from it
  mutable Int128 farthest_ = 0;
};

template <class Result, class A, class B>
Result product(const A& a, const B& b) {
  const Int128 corners[] = {a.low() * b.low(), a.low() * b.high(), a.high() * b.low(),
                            a.high() * b.high()};
  return Result::checked(*std::min_element(corners, corners + 4),
                         *std::max_element(corners, corners + 4), "product");
}

template <int kA, int kB>
auto operator*(const Interval<std::int32_t, kA>& a, const Interval<std::int32_t, kB>& b) {
  using Result = Interval<std::int64_t, kA + kB>;
  if constexpr (kA == kB) {
    if (a.is_same_value(b)) {
      const Int128 size = std::max(a.high(), -a.low());
      return Result::checked(0, size * size, "square");
    }
  }
  return product<Result>(a, b);
}
template <int kA, int kB>
auto operator*(const Interval<std::int64_t, kA>& a, const Interval<std::int32_t, kB>& b) {
  return product<Interval<std::int64_t, kA + kB>>(a, b);
}
template <int kA, int kB>
auto high_product(const Interval<std::int32_t, kA>& a, const Interval<std::int32_t, kB>& b) {
  const auto whole = a * b;
  return Interval<std::int32_t, kA + kB - 32>::checked(whole.low() >> 32, whole.high() >> 32,
                                                       "high product");
}

struct Bounds {
  Int128 low;
  Int128 high;
};

// The raw value with To's fraction, which has to fit Wide where it grows.
template <class To, class Wide, class Raw, int kBits>
Bounds with_fraction(const Interval<Raw, kBits>& value, const char* operation) {
  constexpr int kDropped = kBits - To::fractional_bits;
  const auto changed = [](Int128 raw) {
    if constexpr (kDropped > 0) return (raw + (Int128{1} << (kDropped - 1))) >> kDropped;
    return raw * (Int128{1} << (kDropped < 0 ? -kDropped : 0));
  };
  const auto result = Interval<Wide, To::fractional_bits>::checked(
      changed(value.low()), changed(value.high()), operation);
  return {result.low(), result.high()};
}

template <class To, class Raw, int kBits>
To round_to(const Interval<Raw, kBits>& value) {
  using Wide = std::conditional_t<(sizeof(Raw) > sizeof(typename To::Raw)), Raw, typename To::Raw>;
  if constexpr (std::is_same_v<To, Interval<Raw, kBits>>) {
    return value;
  } else {
    const Bounds changed = with_fraction<To, Wide>(value, "round_to");
    return To::checked(changed.low, changed.high, "round_to");
  }
}

template <class To, class Raw, int kBits>
To saturate_to(const Interval<Raw, kBits>& value) {
  constexpr Int128 kMin = std::numeric_limits<typename To::Raw>::min();
  constexpr Int128 kMax = std::numeric_limits<typename To::Raw>::max();
  const Bounds changed = with_fraction<To, std::int64_t>(value, "saturate_to");
  return To::checked(std::clamp(changed.low, kMin, kMax), std::clamp(changed.high, kMin, kMax),
                     "saturate_to");
}

template <int kBits, class Raw, int kFraction>
auto divide_by_power_of_two(const Interval<Raw, kFraction>& value) {
  return Interval<Raw, kFraction + kBits>::within(value.low(), value.high());
}

}  // namespace fog::proof
