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
#include "recording/unit_spelling.hpp"
#include "support/input_error.hpp"

namespace fogcomp::recording {

/// A calendar by which loggers write a time as one number.
struct TimeScale {
  const char* name;  ///< for messages: "UNIX"
  const char* unit;  ///< as --columns has it
  double zero_s;     ///< where it begins, seconds since 1970-01-01
};

/// The first times of a file, as it writes them.
struct TimesSeen {
  double first = 0;
  /// From row to row, typical and in the mean; 0 if there is one row. Packets and gaps move one of
  /// them only.
  double median_spacing = 0;
  double mean_spacing = 0;
  bool are_whole = true;  ///< numbers without a fraction
};

/// What a number in a column of times may mean.
struct TimeMeaning {
  Unit unit{};
  const TimeScale* scale = nullptr;  ///< nullptr: from power-on, or of a calendar not known
};

/// Whether a time can count from power-on: less than the longest run (rules::kMaxRunHours).
bool is_since_power_on(double number, const Unit& unit);

/// The calendar of which a number in that unit is a possible date (rules::kMinUnixTimeS to
/// kMaxUnixTimeS); nullptr if none.
const TimeScale* scale_of(double number, const Unit& unit);

/// Meanings of times without a unit: those that give a possible date and a usual period
/// (rules::kMinUsualPeriodS to kMaxUsualPeriodS). Whole numbers that count by more than one may be
/// seconds or milliseconds. Other times since power-on are in finer units, or
/// seconds of a calendar that is not known, only if they cannot be in seconds. Empty if nothing
/// fits.
std::vector<TimeMeaning> possible_meanings(const TimesSeen& times);

/// Whether times that are taken in seconds may be in milliseconds as well: whole numbers with a
/// usual period in both.
bool may_be_milliseconds(const TimesSeen& times);

/// Whether times are those of a clock, written hhmmss: as such they are evenly spaced, as numbers
/// they jump at each full minute.
bool are_of_clock(const std::vector<double>& times);

/// "s since power-on, a sample each 0.005 s".
std::string meaning_words(const TimeMeaning& meaning, const TimesSeen& times);

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

  /// Whether times count from power-on, and not from the first sample, as those of a calendar do.
  bool knows_power_on() const {
    return time == TimeFormat::number || header.day_order == DayOrder::no_date;
  }
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
/// (possible_meanings()). `lines`: the first ones of the file. Throws InputError for times of no
/// known form and for those that can mean several things, with the --columns that says which.
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
