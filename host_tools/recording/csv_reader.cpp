#include "recording/csv_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/columns.hpp"
#include "recording/csv_lines.hpp"
#include "recording/csv_row.hpp"
#include "recording/long_recording.hpp"
#include "recording/sparse_columns.hpp"
#include "recording/sparse_input_rate.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::string fault_of_range(std::size_t slot, const CsvRow& row) {
  const ColumnInfo& column = kColumns[slot];
  return format("%s is %.6g, outside %g to %g", std::string(column.name).c_str(), row.values[slot],
                column.min, column.max);
}

std::string fault_of_time(double first_s, double previous_s, double time_s, bool of_calendar) {
  if (time_s == previous_s && of_calendar) {
    return format("time repeats, %.15g s from the first sample; has it enough digits?", time_s);
  }
  if (time_s == previous_s) return format("time_s repeats %.15g", time_s);
  // Far back to where the recording began: not one wrong line.
  constexpr double kBeginning = 0.01;
  if (previous_s > first_s && time_s - first_s < kBeginning * (previous_s - first_s)) {
    return format(
        "time_s begins again at %.15g after %.15g; if the recorder was started again "
        "there, split the file at this line: each power-on is a run",
        time_s, previous_s);
  }
  return format("time_s goes back from %.15g to %.15g", previous_s, time_s);
}

/// Collects the good rows of a Recording and counts the bad ones.
class RowCollector {
 public:
  RowCollector(const CsvLayout& layout, const InputFile& file, const ReadOptions& options,
               LineNumbers& lines, std::size_t min_rows)
      : reader_(layout),
        file_(file),
        options_(options),
        lines_(lines),
        long_recording_(options, min_rows) {
    recording_.file = file.path();
    recording_.power_on_unknown = layout.time != TimeFormat::number;
    for (const std::size_t slot : layout.header.slots) {
      if (slot < kColumns.size()) columns_.push_back({slot, &(recording_[kColumns[slot].column])});
    }
  }

  /// Reserves memory for all rows of a file of `bytes`, estimated from the length of one row:
  /// growing would copy every column several times.
  void reserve(std::size_t bytes, std::size_t bytes_of_line) {
    const std::size_t rows = std::min(bytes / (bytes_of_line + 1) + 1, long_recording_.part_rows());
    for (const auto& [slot, values] : columns_) values->reserve(rows);
  }

  void add(std::string_view line) {
    CsvRow row;
    if (!reader_.read(line, row)) return refuse(reader_.fault_of(line));
    if (row.lacks_values && lacks_needed(row)) return;
    for (const auto& [slot, values] : columns_) {
      const double value = row.values[slot];
      if (!kColumns[slot].can_be(value) && !std::isnan(value)) {
        return refuse(fault_of_range(slot, row));
      }
    }
    const double time_s = row.values[kTimeSlot];
    if (!(time_s > previous_s_)) {
      return refuse(fault_of_time(first_s_, previous_s_, time_s, recording_.power_on_unknown));
    }
    if (recording_.rows() == long_recording_.part_rows()) hand_over();
    if (std::isinf(previous_s_)) first_s_ = time_s;
    previous_s_ = time_s;
    lines_.add(recording_.rows(), file_.line_number());
    if (!row.label.empty() || !recording_.labels.empty()) add_label(row.label);
    for (const auto& [slot, values] : columns_) values->push_back(row.values[slot]);
    sparse_ = sparse_ || row.lacks_values;
  }

  Recording finish() {
    const bool none = recording_.rows() == 0 && long_recording_.rows_taken() == 0;
    if (none && recording_.bad_rows == 0 && recording_.empty_rows > 0) {
      throw InputError(file_.path(), "has no sample with a time and a rate");
    }
    if (none) {
      throw InputError(file_.path(), recording_.bad_rows == 0
                                         ? "has a header but no samples"
                                         : "has no good row; the first bad one: " + first_fault_);
    }
    if (recording_.empty_rows > 0) {
      options_.watch.say(file_.path(), counted(recording_.empty_rows, "sample") +
                                           " left out: no time or rate, the first at line " +
                                           std::to_string(first_empty_));
    }
    if (recording_.bad_rows > 0) {
      options_.watch.say(file_.path(), counted(recording_.bad_rows, "bad row") +
                                           " left out, the first: " + first_fault_);
    }
    complete_sparse();
    if (!long_recording_.begun()) return std::move(recording_);
    hand_over();
    Recording means = long_recording_.finish(file_.path());
    means.bad_rows = recording_.bad_rows;
    means.empty_rows = recording_.empty_rows;
    means.masks = std::move(recording_.masks);
    return means;
  }

 private:
  struct Target {
    std::size_t slot;
    std::vector<double>* values;
  };

  void complete_sparse() {
    std::vector<double>& input_rate = recording_.input_rate_dph;
    const bool is_held = blank_held_readings(recording_.time_s, recording_.rate_dph, input_rate);
    if (is_held) {
      options_.watch.say(file_.path(), "input_rate_dph repeats each reading until the next one");
    }
    if (sparse_ || is_held) complete_sparse_columns(recording_, lines_, options_.watch);
    sparse_ = false;
  }

  void hand_over() {
    complete_sparse();
    long_recording_.take(recording_, lines_, file_.where());
    for (const auto& [slot, values] : columns_) values->reserve(long_recording_.part_rows());
  }

  // A row needs time and rate; other values are completed later.
  bool lacks_needed(const CsvRow& row) {
    if (!std::isnan(row.values[kTimeSlot]) && !std::isnan(row.values[kRateSlot])) return false;
    if (recording_.empty_rows++ == 0) first_empty_ = file_.line_number();
    return true;
  }

  void refuse(const std::string& fault) {
    if (!options_.skip_bad_rows) {
      throw InputError(file_.where(), fault + "; correct the line or give --skip-bad-rows");
    }
    if (recording_.bad_rows++ == 0) {
      first_fault_ = "line " + std::to_string(file_.line_number()) + ", " + fault;
    }
  }

  void add_label(std::string_view label) {
    if (label == last_label_ && !recording_.labels.empty()) return;
    last_label_ = label;
    recording_.labels.push_back({recording_.rows(), displayable(label)});
  }

  CsvRowReader reader_;
  const InputFile& file_;
  const ReadOptions& options_;
  LineNumbers& lines_;
  Recording recording_;
  LongRecording long_recording_;
  std::vector<Target> columns_;
  double first_s_ = 0;
  double previous_s_ = -std::numeric_limits<double>::infinity();
  std::string first_fault_;
  std::size_t first_empty_ = 0;  // line of the first row without time or rate
  bool sparse_ = false;
  std::string last_label_;
};

// Estimated from the length of the first lines; later ones, with longer times, are less than twice
// as long.
std::size_t min_rows_of(const InputFile& file, std::string_view head) {
  const auto lines = static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n'));
  if (head.empty() || file.is_utf16()) return 0;
  return static_cast<std::size_t>(static_cast<double>(file.size()) / 2 *
                                  static_cast<double>(lines) / static_cast<double>(head.size()));
}

}  // namespace

Recording read_csv(InputFile& file, const ReadOptions& options, LineNumbers& lines) {
  // once, for a line that is longer than the buffer
  const std::string_view head = file.peek();
  std::string_view line;
  if (head.find('\n') == std::string_view::npos && !file.at_end()) file.next_line(line);
  const CsvLayout layout =
      find_csv_layout({head, file.at_end(), file.is_utf16(), file.path()}, options);
  RowCollector collector(layout, file, options, lines, min_rows_of(file, head));
  for (std::size_t i = 0; i < layout.lines_before_rows; ++i) file.next_line(line);
  bool reserved = false;
  while (file.next_line(line)) {
    if (is_comment_or_blank(line)) continue;
    if (!reserved) collector.reserve(file.size(), line.size());
    reserved = true;
    collector.add(line);
  }
  return collector.finish();
}

}  // namespace fogcomp::recording
