#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "recording/csv_fields.hpp"
#include "recording/csv_header.hpp"
#include "recording/recording.hpp"
#include "recording/time_scale.hpp"
#include "support/input_error.hpp"

namespace fogcomp::recording {

enum class TimeFormat : std::uint8_t {
  number,
  dates,     ///< numbers of a calendar
  calendar,  ///< a date and a time of day (read_calendar_time())
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

/// Columns, first rows and separator. `header`: as understood; nullptr: what the names suggest.
CsvColumns columns_in(const LikelyHeader& likeliest, const CsvHeader* header,
                      const std::vector<std::string_view>& lines);

/// Finds out how the times of a file are written, and sets the layout's format and, if its name has
/// no unit, that of the column: the only one that gives a possible date or period
/// (time_scale.hpp). `lines`: the first ones of the file. Throws InputError for times of no known
/// form and for those that can mean several things, with the --columns that says which.
void understand_times(const std::vector<std::string_view>& lines, const std::string& path,
                      CsvLayout& layout);

/// Throws InputError if another column has times that run otherwise than those that are taken, in
/// units that allow to say so, and nobody chose: two tables that stand side by side. `lines`: the
/// first ones of the file.
void refuse_second_times(const std::vector<std::string_view>& lines, const std::string& path,
                         const CsvLayout& layout);

/// The refusal if the numbers of a column that is read have three digits behind their mark,
/// all of them, and no number of the file tells what the mark is: "12,389" is 12.389 or 12389. A
/// point between columns that commas or blanks separate is the decimal point of programs, and no
/// question but for counts, which are whole. `lines`: the first ones of the file.
std::optional<InputError> refusal_of_marks(const std::vector<std::string_view>& lines,
                                           const std::string& path, const CsvLayout& layout);

}  // namespace fogcomp::recording
