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

/// Layout of a CSV: everything that is known before its rows are read.
struct CsvLayout {
  CsvDialect dialect;
  CsvHeader header;
  TimeFormat time = TimeFormat::number;
  std::size_t lines_before_rows = 0;  ///< header, units, and lines before them
};

struct FileHead {
  std::string_view text;  ///< first bytes of the file
  bool whole = false;     ///< `text` is the whole file
  bool utf16 = false;
  std::string path{};
};

/// Finds separator, decimal mark and header: those with which the header has a time, a temperature
/// and a rate, and the rows have as many fields, with numbers. Throws InputError if none or several
/// fit, and like understand_header(). Reports the interpretation to options.watch in one line,
/// unless it is the plain format.
CsvLayout find_csv_layout(const FileHead& head, const ReadOptions& options);

/// Blank, or a comment ('#', '%').
bool is_comment_or_blank(std::string_view line);

}  // namespace fogcomp::recording
