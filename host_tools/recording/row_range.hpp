#pragma once

#include <cstddef>
#include <vector>

#include "recording/decision_rules.hpp"

namespace fogcomp::recording {

/// Rows [first, end) of a series.
struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - first; }
};

/// Ranges that begin at `starts`, in order; the last one ends at `end`.
inline std::vector<RowRange> ranges_from(const std::vector<std::size_t>& starts, std::size_t end) {
  std::vector<RowRange> ranges;
  for (const std::size_t start : starts) {
    if (!ranges.empty()) ranges.back().end = start;
    ranges.push_back({start, end});
  }
  return ranges;
}

/// Whether rows of length `row_s` are missing between two that are `spacing_s` apart.
inline bool is_gap(double spacing_s, double row_s) {
  return spacing_s > rules::kMaxSpacing * row_s;
}

}  // namespace fogcomp::recording
