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

  std::int32_t next();
  /// Next word if within [min, max], else `min`.
  std::int32_t next(std::int32_t min, std::int32_t max);
  /// Next word if at least `min`, else `min`.
  std::int32_t next_from(std::int32_t min);
  /// Next word if within [0, max], else 0.
  std::size_t next_count(std::size_t max);

  Span<const std::int32_t> next_words(std::size_t count);
  /// Words behind their own count, which is at most `max`.
  Span<const std::int32_t> next_list(std::size_t max);

  void require(bool condition);

  /// Whether all words so far were present and in range.
  bool good() const { return good_; }
  bool at_end() const { return rest_.size == 0; }

 private:
  Span<const std::int32_t> rest_;
  bool good_ = true;
};

}  // namespace fog
