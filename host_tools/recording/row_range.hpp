#pragma once

#include <cstddef>

namespace fogcomp {

/// Rows [first, end) of a series.
struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - first; }
};

/// Whether something is missing between two rows that lie `spacing_s` apart, where a row is `row_s`
/// long.
inline bool is_gap(double spacing_s, double row_s) {
  constexpr double kMaxSpacing = 1.5;  // rows; a row that is lost makes 2
  return spacing_s > kMaxSpacing * row_s;
}

}  // namespace fogcomp
