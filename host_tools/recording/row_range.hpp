#pragma once

#include <cstddef>

#include "recording/decision_rules.hpp"

namespace fogcomp::recording {

/// Rows [first, end) of a series.
struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - first; }
};

/// Whether something is missing between two rows that lie `spacing_s` apart, where a row is `row_s`
/// long.
inline bool is_gap(double spacing_s, double row_s) {
  return spacing_s > rules::kMaxSpacing * row_s;
}

}  // namespace fogcomp::recording
