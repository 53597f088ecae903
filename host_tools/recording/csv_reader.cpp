#include "recording/csv_reader.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/columns.hpp"
#include "recording/csv_header.hpp"
#include "recording/scan_decimal.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_space(char character) {
  return character == ' ' || character == '\t';
}

bool is_comment_or_blank(std::string_view line) {
  while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
  return line.empty() || line.front() == '#';
}

struct Row {
  std::array<double, kColumns.size()> values{};
  std::string_view label;
};

/// Reads the fields of `line` into `row`; false where a field is missing, surplus or no number.
bool parse_row(const CsvHeader& header, std::string_view line, Row& row) {
  const char* p = line.data();
  const char* const end = p + line.size();
  const std::size_t fields = header.slots.size();
  for (std::size_t field = 0; field < fields; ++field) {
    const std::size_t slot = header.slots[field];
    if (slot < row.values.size()) {
      while (p < end && is_space(*p)) ++p;
      p = scan_decimal(p, end, row.values[slot]);
      if (p == nullptr) return false;
      while (p < end && is_space(*p)) ++p;
    } else {
      const char* const start = p;
      p = std::find(p, end, ',');
      if (slot == CsvHeader::kSegmentLabel) {
        row.label = trim({start, static_cast<std::size_t>(p - start)});
      }
    }
    const bool last = field + 1 == fields;
    if (last != (p == end)) return false;
    if (!last && *p++ != ',') return false;
  }
  return true;
}

/// Why parse_row refused `line`.
std::string fault_of(const CsvHeader& header, std::string_view line) {
  const std::vector<std::string> fields = split(line, ',');
  if (fields.size() != header.slots.size()) {
    return counted(fields.size(), "field") + " where the header has " +
           std::to_string(header.slots.size());
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (header.slots[i] >= kColumns.size()) continue;
    const std::string text(trim(fields[i]));
    if (text.empty()) return header.names[i] + " is empty";
    double value = 0;
    const char* const end = text.data() + text.size();
    if (scan_decimal(text.data(), end, value) != end) {
      return header.names[i] + " is '" + printable(text) + "', not a finite number";
    }
  }
  return "not a row of numbers";
}

std::string fault_of_range(std::size_t slot, const Row& row) {
  const ColumnInfo& column = kColumns[slot];
  return format("%s is %.6g, outside %g to %g", std::string(column.name).c_str(), row.values[slot],
                column.least, column.most);
}

std::string fault_of_time(double previous_s, double time_s) {
  if (time_s == previous_s) return format("time_s repeats %.15g", time_s);
  return format("time_s goes back from %.15g to %.15g", previous_s, time_s);
}

CsvHeader read_header(InputFile& file, const ReadOptions& options) {
  std::string_view line;
  while (file.next_line(line)) {
    if (file.line_number() == 1 && line.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
      line.remove_prefix(kByteOrderMark.size());
    }
    if (!is_comment_or_blank(line)) {
      return parse_csv_header(line, file.path(), file.where(), options);
    }
  }
  throw InputError(file.path(), "has no header line and no rows; is it the right file?");
}

/// Collects good rows into a Recording and bad ones into a count.
class RowCollector {
 public:
  RowCollector(const CsvHeader& header, const InputFile& file, const ReadOptions& options,
               LineNumbers& lines)
      : header_(header), file_(file), options_(options), lines_(lines) {
    recording_.file = file.path();
    for (const std::size_t slot : header.slots) {
      if (slot < kColumns.size()) columns_.push_back({slot, &(recording_[kColumns[slot].column])});
    }
  }

  /// Room for all rows of a file of `bytes`, judged by the length of one of them: growing as it
  /// goes would copy every column several times.
  void reserve(std::size_t bytes, std::size_t bytes_of_line) {
    const std::size_t rows = std::min(bytes / (bytes_of_line + 1) + 1, kMostRows);
    for (const auto& [slot, values] : columns_) values->reserve(rows);
  }

  void add(std::string_view line) {
    Row row;
    if (!parse_row(header_, line, row)) return refuse(fault_of(header_, line));
    row.values[kRateSlot] *= header_.dph_per_rate_unit;
    for (const auto& [slot, values] : columns_) {
      if (!kColumns[slot].can_be(row.values[slot])) return refuse(fault_of_range(slot, row));
    }
    const double time_s = row.values[kTimeSlot];
    if (!(time_s > previous_s_)) return refuse(fault_of_time(previous_s_, time_s));
    if (recording_.rows() == kMostRows) {
      throw InputError(file_.where(), format("more than %zu million rows; average or cut the file",
                                             kMostRows / 1'000'000));
    }
    previous_s_ = time_s;
    lines_.add(recording_.rows(), file_.line_number());
    if (!row.label.empty() || !recording_.labels.empty()) add_label(row.label);
    for (const auto& [slot, values] : columns_) values->push_back(row.values[slot]);
  }

  Recording finish() {
    if (recording_.rows() == 0) {
      throw InputError(file_.path(), recording_.bad_rows == 0
                                         ? "has a header but no rows"
                                         : "has no good row; the first bad one: " + first_fault_);
    }
    if (recording_.bad_rows > 0) {
      options_.watch.say(file_.path(), counted(recording_.bad_rows, "bad row") +
                                           " left out, the first: " + first_fault_);
    }
    return std::move(recording_);
  }

 private:
  static constexpr std::size_t kTimeSlot = static_cast<std::size_t>(Column::time_s);
  static constexpr std::size_t kRateSlot = static_cast<std::size_t>(Column::rate_dph);

  struct Target {
    std::size_t slot;
    std::vector<double>* values;
  };

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

  const CsvHeader& header_;
  const InputFile& file_;
  const ReadOptions& options_;
  LineNumbers& lines_;
  Recording recording_;
  std::vector<Target> columns_;
  double previous_s_ = -std::numeric_limits<double>::infinity();
  std::string first_fault_;
  std::string last_label_;
};

}  // namespace

Recording read_csv(InputFile& file, const ReadOptions& options, LineNumbers& lines) {
  const CsvHeader header = read_header(file, options);
  RowCollector collector(header, file, options, lines);
  bool reserved = false;
  std::string_view line;
  while (file.next_line(line)) {
    if (is_comment_or_blank(line)) continue;
    if (!reserved) collector.reserve(file.size(), line.size());
    reserved = true;
    collector.add(line);
  }
  return collector.finish();
}

}  // namespace fogcomp::recording
