#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "recording/csv_fields.hpp"
#include "recording/csv_header.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

enum class TimeFormat : std::uint8_t {
  number,
  since_1970,  ///< a number
  calendar,    ///< ISO 8601
};

/// How a CSV is laid out: everything that is known of it before its rows are read.
struct CsvLayout {
  CsvDialect dialect;
  CsvHeader header;
  TimeFormat time = TimeFormat::number;
  std::size_t lines_before_rows = 0;  ///< header, units, and what stands before them
};

struct FileHead {
  std::string_view text;  ///< of the file's first bytes
  bool whole = false;     ///< all of it
  bool utf16 = false;
  std::string path{};
};

/// Finds separator, decimal mark and header: those with which the header has a time, a temperature
/// and a rate, and the rows below as many fields as the header and numbers in them. Throws
/// InputError where there are none or more than one, and what understand_header() throws. What was
/// understood is told to options.watch in one line, where it is not the plain format.
CsvLayout find_csv_layout(const FileHead& head, const ReadOptions& options);

/// Blank, or a comment ('#', '%').
bool is_comment_or_blank(std::string_view line);

}  // namespace fogcomp::recording
