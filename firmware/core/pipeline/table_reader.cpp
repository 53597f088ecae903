#include "core/pipeline/table_reader.hpp"

#include <limits>

// Not in the header: inline, each of the reader's many uses would be as large as the function.
namespace fog {

std::int32_t TableReader::next() {
  if (rest_.size == 0) {
    good_ = false;
    return 0;
  }
  const std::int32_t word = rest_[0];
  rest_ = {rest_.data + 1, rest_.size - 1};
  return word;
}

std::int32_t TableReader::next(std::int32_t min, std::int32_t max) {
  const std::int32_t word = next();
  if (word >= min && word <= max) return word;
  good_ = false;
  return min;
}

std::int32_t TableReader::next_from(std::int32_t min) {
  return next(min, std::numeric_limits<std::int32_t>::max());
}

std::size_t TableReader::next_count(std::size_t max) {
  return static_cast<std::size_t>(next(0, static_cast<std::int32_t>(max)));
}

Span<const std::int32_t> TableReader::next_words(std::size_t count) {
  if (count > rest_.size) {
    good_ = false;
    return {};
  }
  const Span<const std::int32_t> words{rest_.data, count};
  rest_ = {rest_.data + count, rest_.size - count};
  return words;
}

Span<const std::int32_t> TableReader::next_list(std::size_t max) {
  return next_words(next_count(max));
}

void TableReader::require(bool condition) {
  good_ = good_ && condition;
}

}  // namespace fog
