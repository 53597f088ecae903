#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// The latest `length` samples in memory that somebody else owns: a ring, filled downwards, whose
/// first `window` slots are repeated behind its end, so that the newest `window` samples, and the
/// oldest, can always be read as one array, newest first.
class SampleLine {
 public:
  static constexpr std::size_t memory(std::size_t length, std::size_t window) {
    return length + window;
  }

  /// `memory`: memory(length, window) values; 2 <= window <= length, or length 1 for one that
  /// must not be used.
  SampleLine(std::int32_t* memory, std::size_t length, std::size_t window)
      : first_(memory),
        last_(memory + length - 1),
        oldest_(last_),
        repeated_end_(memory + window),
        length_(length) {}

  /// As if `value` had come for ever, as far as the newest and the oldest `window` samples show it.
  /// Until as many have been pushed as the line is long, fill_further() has to precede each: so
  /// that no sample pays for the whole line.
  void fill(std::int32_t value, std::size_t window) {
    for (std::size_t i = 0; i < window; ++i) {
      write(first_ + i, value);
      *(last_ - i) = value;
    }
  }
  void fill_further(std::size_t window) {
    if (oldest_slot() >= 2 * window) *(oldest_ - window) = *oldest_;
  }

  /// In place of the oldest.
  [[gnu::always_inline]] void push(std::int32_t value) {
    std::int32_t* const at = oldest_;
    write(at, value);
    oldest_ = at == first_ ? last_ : at - 1;
  }

  /// The newest `window` samples.
  const std::int32_t* newest() const { return oldest_ + 1; }

  /// The oldest `window` samples.
  [[gnu::always_inline]] const std::int32_t* oldest(std::size_t window) const {
    const std::int32_t* last = oldest_;
    if (oldest_slot() < window - 1) last += length_;
    return last - (window - 1);
  }

  /// The oldest one, which the next to come will replace.
  std::int32_t oldest() const { return *oldest_; }

  /// Corrects the newest.
  void replace_newest(std::int32_t value) { write(first_ + newest_slot(), value); }

  std::size_t length() const { return length_; }

  /// Where a sample stands, 0 to length - 1: the same until it leaves the line.
  std::size_t newest_slot() const { return oldest_slot() + 1 == length_ ? 0 : oldest_slot() + 1; }
  std::size_t oldest_slot() const { return static_cast<std::size_t>(oldest_ - first_); }

 private:
  [[gnu::always_inline]] void write(std::int32_t* at, std::int32_t value) {
    *at = value;
    if (at < repeated_end_) at[length_] = value;
  }

  std::int32_t* first_;
  std::int32_t* last_;  // slot length - 1
  std::int32_t* oldest_;
  const std::int32_t* repeated_end_;
  std::size_t length_;
};

}  // namespace fog
