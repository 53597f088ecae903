#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/span.hpp"

namespace fog {

/// Reads words from a table in order. Remembers a read past the end or a value out of range, so
/// that callers need not test each read.
class TableReader {
 public:
  explicit TableReader(Span<const std::int32_t> table) : rest_(table) {}

  std::int32_t next() {
    if (rest_.size == 0) {
      good_ = false;
      return 0;
    }
    const std::int32_t word = rest_[0];
    rest_ = {rest_.data + 1, rest_.size - 1};
    return word;
  }

  /// Next word if within [min, max], else `min`.
  std::int32_t next(std::int32_t min, std::int32_t max) {
    const std::int32_t word = next();
    if (word >= min && word <= max) return word;
    good_ = false;
    return min;
  }

  Span<const std::int32_t> next_words(std::size_t count) {
    if (count > rest_.size) {
      good_ = false;
      return {};
    }
    const Span<const std::int32_t> words{rest_.data, count};
    rest_ = {rest_.data + count, rest_.size - count};
    return words;
  }

  void require(bool condition) { good_ = good_ && condition; }

  /// Whether all words so far were present and in range.
  bool good() const { return good_; }
  bool at_end() const { return rest_.size == 0; }

 private:
  Span<const std::int32_t> rest_;
  bool good_ = true;
};

}  // namespace fog
