#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "recording/csv_layout.hpp"

namespace fogcomp::recording {

/// Columns that a recording must have: time, temperature, rate.
constexpr std::size_t kRequired = 3;

/// A line that may be the header, parted by `separator`.
struct LikelyHeader {
  std::vector<std::string> names{};
  char separator = ',';
  std::size_t line = 0;
  std::size_t found = 0;    ///< required columns among the names
  bool is_numbers = false;  ///< a first row instead

  std::size_t first_row() const { return is_numbers ? line : line + 1; }
  /// The larger, the likelier.
  std::tuple<std::size_t, bool, std::ptrdiff_t, std::size_t> rank() const {
    return {found, names.size() >= kRequired, -static_cast<std::ptrdiff_t>(line), names.size()};
  }
};

/// "tabs", "blanks" or "';'".
std::string separator_words(char separator);

/// Fills in the columns, first rows and separator of `found`. `header`: as understood; nullptr:
/// what the names suggest.
void describe_columns(const LikelyHeader& likeliest, const CsvHeader* header,
                      const std::vector<std::string_view>& lines, CsvColumns& found);

}  // namespace fogcomp::recording
