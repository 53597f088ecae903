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

/// Whether rows of length `row_s` are missing between two that are `spacing_s` apart.
inline bool is_gap(double spacing_s, double row_s) {
  return spacing_s > rules::kMaxSpacing * row_s;
}

}  // namespace fogcomp::recording
