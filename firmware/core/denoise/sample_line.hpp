#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// The latest `length` samples in memory owned by somebody else: a ring, filled downwards. Its
/// first `window` slots are repeated after its end, so that the newest and the oldest `window`
/// samples can always be read as one array, newest first.
class SampleLine {
 public:
  static constexpr std::size_t memory(std::size_t length, std::size_t window) {
    return length + window;
  }

  /// `memory` has memory(length, window) values; 2 <= window <= length, or length 1 for a line that
  /// must not be used.
  [[gnu::always_inline]] SampleLine(std::int32_t* memory, std::size_t length, std::size_t window)
      : first_(memory),
        last_(memory + length - 1),
        oldest_(last_),
        repeated_end_(memory + window),
        length_(length) {}

  /// Starts as if `value` had been the input for ever, as far as the newest and the oldest `window`
  /// samples show it. fill_further() has to be called before each of the next `length` pushes; this
  /// spreads the work of filling over the samples.
  [[gnu::always_inline]] void fill(std::int32_t value, std::size_t window) {
    // The oldest samples are at the end, followed by the repeated newest ones.
    for (std::int32_t* at = last_ + 1 - window; at <= last_ + window; ++at) *at = value;
  }
  void fill_further(std::size_t window) {
    if (oldest_ >= first_ + window) *(oldest_ - window) = *oldest_;
  }

  /// Replaces the oldest sample.
  [[gnu::always_inline]] void push(std::int32_t value) {
    std::int32_t* const at = oldest_;
    *at = value;
    std::int32_t* next = at - 1;
    if (at < repeated_end_) {  // rarely: the first slot is among them
      at[length_] = value;
      if (at == first_) next = last_;
    }
    oldest_ = next;
  }

  /// The newest `window` samples.
  const std::int32_t* newest() const { return oldest_ + 1; }

  /// The oldest `window` samples.
  [[gnu::always_inline]] const std::int32_t* oldest(std::size_t window) const {
    const std::int32_t* last = oldest_;
    if (last < first_ + (window - 1)) last += length_;
    return last - (window - 1);
  }

  /// The oldest sample, which the next push replaces.
  std::int32_t oldest() const { return *oldest_; }

  /// Replaces the newest sample.
  void replace_newest(std::int32_t value) {
    std::int32_t* const at = oldest_ == last_ ? first_ : oldest_ + 1;
    *at = value;
    if (at < repeated_end_) at[length_] = value;
  }

  std::size_t length() const { return length_; }

 private:
  std::int32_t* first_;
  std::int32_t* last_;  // slot length - 1
  std::int32_t* oldest_;
  const std::int32_t* repeated_end_;
  std::size_t length_;
};

}  // namespace fog
