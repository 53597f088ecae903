#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

/// Lines of a file's beginning, without their ends, as many as a layout is decided by. A last line
/// that has not been read whole is left out.
std::vector<std::string_view> first_lines(const FileHead& head);

/// Blank, or a comment ('#', '%').
bool is_comment_or_blank(std::string_view line);

/// A comment line without its mark: numpy and others write the names there.
std::string_view uncommented(std::string_view line);

/// The fields of a line; a unit that a blank separates from its name belongs to it.
std::vector<std::string> names_in(std::string_view line, char separator);

/// Whether all fields are units, in brackets or not, empty or "-", and at least one is a unit.
bool is_units_row(const std::vector<std::string>& fields);

/// A number, with either decimal mark, or a time of a calendar: no name.
bool is_value(std::string_view field);

bool is_all_numbers(const std::vector<std::string>& names);

/// The first line from `line` on that is neither a comment nor blank; lines.size() if none is.
std::size_t next_row(const std::vector<std::string_view>& lines, std::size_t line);

/// Calls take(line, fields) for each row of a layout among a file's first lines.
template <class Take>
void for_each_row(const std::vector<std::string_view>& lines, const CsvLayout& layout, Take take) {
  std::vector<std::string_view> fields;
  for (std::size_t i = next_row(lines, layout.lines_before_rows); i < lines.size();
       i = next_row(lines, i + 1)) {
    split_fields(lines[i], layout.dialect.separator, fields);
    take(i, fields);
  }
}

}  // namespace fogcomp::recording
