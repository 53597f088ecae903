#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "recording/csv_fields.hpp"
#include "recording/csv_header.hpp"
#include "recording/recording.hpp"
#include "recording/time_scale.hpp"

namespace fogcomp::recording {

enum class TimeFormat : std::uint8_t {
  number,
  dates,     ///< numbers of a calendar
  calendar,  ///< ISO 8601
};

/// Layout of a CSV: everything that is known before its rows are read.
struct CsvLayout {
  CsvDialect dialect;
  CsvHeader header;
  TimeFormat time = TimeFormat::number;
  const TimeScale* scale = nullptr;   ///< of dates, if it is known
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

/// The columns of a CSV for somebody who is to say what they are: as they are understood or, where
/// they cannot be, as their names suggest.
struct CsvColumns {
  struct Column {
    std::string name;    ///< as in the file; "": it has none
    std::string choice;  ///< as --columns names it
    std::string key;     ///< what it is or could be, as --columns has it: "rate"; "": nothing
    std::string unit;    ///< that its name or a row of units says; "": none
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< fields of the first ones
  std::string separator;                       ///< in words
  std::string refusal;                         ///< why they cannot be understood; "": they can
};

/// Of the header that find_csv_layout() takes, else of the line that is most like one. What was
/// understood is told to options.watch.
CsvColumns look_at_columns(const FileHead& head, const ReadOptions& options);

}  // namespace fogcomp::recording
