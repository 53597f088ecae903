#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// What the fields of a CSV's rows mean, from its header line.
struct CsvHeader {
  /// Special values of `slots`; all others index kColumns.
  static constexpr std::size_t kIgnored = 100;
  static constexpr std::size_t kSegmentLabel = 101;

  std::vector<std::string> names;  ///< as in the file, one per field
  std::vector<std::size_t> slots;  ///< of each field
  /// Factor of the rate field: 1, or deg/h per count where the file has `counts`.
  double dph_per_rate_unit = 1;
  bool has(std::size_t slot) const;
};

/// Reads the header line of `file`; `where` is its `FILE:LINE`. Throws InputError for a duplicate
/// or missing column, a wrong separator, numbers instead of names, or `counts` without a scale
/// factor. Unknown columns, and options that this file makes void, are told to options.watch.
CsvHeader parse_csv_header(std::string_view text, const std::string& file, const std::string& where,
                           const ReadOptions& options);

/// `field` as a message may show it: displayable(), and at most 40 bytes of it.
std::string printable(std::string_view field);

}  // namespace fogcomp::recording
