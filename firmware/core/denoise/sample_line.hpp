#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/span.hpp"

namespace fog {

/// The latest samples, newest first, in memory that somebody else owns. Any `window` of them in a
/// row can be read as one array: a ring whose first part is repeated behind its end.
class SampleLine {
 public:
  static constexpr std::size_t memory(std::size_t length, std::size_t window) {
    return length + window - 1;
  }

  SampleLine() = default;
  /// `memory` has memory(length, window) values; window <= length.
  SampleLine(Span<std::int32_t> memory, std::size_t length)
      : memory_(memory), length_(length), repeated_(memory.size - length) {}

  void fill(std::int32_t value) {
    for (std::int32_t& slot : memory_) slot = value;
  }

  void push(std::int32_t value) {
    newest_ = newest_ == 0 ? length_ - 1 : newest_ - 1;
    write(newest_, value);
  }

  /// The samples from `age` on; at least a window of them where age <= length - window.
  const std::int32_t* from(std::size_t age) const { return memory_.data + slot(age); }

  std::int32_t in(std::size_t slot) const { return memory_[slot]; }

  /// Corrects the sample of that age.
  void replace(std::size_t age, std::int32_t value) { write(slot(age), value); }

  std::size_t length() const { return length_; }

  /// Where the sample of that age stands, 0 to length - 1: the same until it leaves the line.
  std::size_t slot(std::size_t age) const {
    const std::size_t at = newest_ + age;
    return at < length_ ? at : at - length_;
  }

 private:
  void write(std::size_t at, std::int32_t value) {
    memory_[at] = value;
    if (at < repeated_) memory_[at + length_] = value;
  }

  Span<std::int32_t> memory_;
  std::size_t length_ = 1;
  std::size_t repeated_ = 0;
  std::size_t newest_ = 0;
};

}  // namespace fog
