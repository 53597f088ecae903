#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "recording/csv_layout.hpp"

namespace fogcomp::recording {

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
