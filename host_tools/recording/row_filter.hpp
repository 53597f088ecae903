#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "recording/csv_layout.hpp"

namespace fogcomp::recording {

/// The column of a file that several sensors share, and which of them is wanted: `--where
/// SensorId=1`.
struct RowChoice {
  std::string column{};  ///< name, or number from 1
  std::string value{};   ///< "*": every row
};

/// Parses "SensorId=1"; "" gives an empty choice. Throws InputError for any other text.
RowChoice parse_row_choice(const std::string& text);

/// The rows of a CSV that are read.
class RowFilter {
 public:
  /// By options.where. Throws InputError if the file has no such column.
  RowFilter(const CsvLayout& layout, const ReadOptions& options, const std::string& path);

  bool takes_all() const { return value_ == "*"; }
  bool takes(std::string_view line);
  std::size_t left_out() const { return left_out_; }

 private:
  char separator_;
  std::size_t field_ = 0;
  std::string value_ = "*";
  std::size_t left_out_ = 0;
  std::vector<std::string_view> fields_;
};

/// Columns that nobody reads and that tell runs apart, or good rows from bad ones.
class RowMarks {
 public:
  /// `lines`: the first ones of the file; `layout` must outlive this.
  RowMarks(const std::vector<std::string_view>& lines, const CsvLayout& layout);

  /// The --where that takes the rows before this one, where the time begins again: of a column that
  /// has had one value so far, and has another one here. "" if there is none.
  std::string run_before(std::string_view line, std::size_t line_number) const;

  /// Whether see() has to get all rows: a column is called valid, status or the like.
  bool has_flag() const { return flag_ < layout_.header.slots.size(); }
  void see(std::string_view line);
  /// What was seen, with the --where that takes one value only; "" if there was but one.
  std::string flag_words() const;

 private:
  const CsvLayout& layout_;
  std::vector<std::string> first_row_;
  std::vector<std::size_t> first_change_;  // line number; 0: none among the first lines
  std::vector<std::size_t> changes_;       // there
  std::size_t flag_;
  std::map<std::string, std::size_t> rows_of_flag_;
};

/// Throws InputError if rows of several sensors follow each other in turn and no --where is given:
/// a column that is not understood numbers them (2 to 16 values, each as often, that change in half
/// of the rows and more), and either its name says so or the rates or temperatures of the values
/// differ by more than noise. `lines`: the first ones of the file.
void refuse_several_sensors(const std::vector<std::string_view>& lines, const std::string& path,
                            const CsvLayout& layout, const ReadOptions& options);

}  // namespace fogcomp::recording
