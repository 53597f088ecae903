#include "recording/long_recording.hpp"

#include <algorithm>
#include <utility>

#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/reading.hpp"
#include "recording/row_range.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

// Whether a temperature was read in one of these rows.
bool any_read(const std::vector<bool>& is_read, std::size_t first, std::size_t end) {
  for (std::size_t row = first; row < end && !is_read.empty(); ++row) {
    if (is_read[row]) return true;
  }
  return is_read.empty();
}

double mean_of(const std::vector<double>& column, std::size_t first, std::size_t end) {
  double sum = 0;
  for (std::size_t row = first; row < end; ++row) sum += column[row];
  return sum / static_cast<double>(end - first);
}

bool starts_label(const Recording& recording, std::size_t row) {
  return std::any_of(recording.labels.begin(), recording.labels.end(),
                     [&](const Recording::Label& label) { return label.first_row == row; });
}

// Rows that start a new mean: after gaps and at the names of segments.
std::vector<std::size_t> breaks_of(const Recording& part) {
  std::vector<std::size_t> breaks = part.stretch_starts;
  for (const Recording::Label& label : part.labels) breaks.push_back(label.first_row);
  breaks.push_back(part.rows());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

template <class Column>
Column rows_of(const Column& column, const RowRange& rows) {
  if (column.empty()) return {};
  return Column(column.begin() + static_cast<std::ptrdiff_t>(rows.first),
                column.begin() + static_cast<std::ptrdiff_t>(rows.end));
}

// Some rows as a recording; the first one has the name of their segment.
Recording rows_of(const Recording& whole, const RowRange& rows) {
  Recording part;
  part.file = whole.file;
  part.power_on_unknown = whole.power_on_unknown;
  part.temperature_period_s = whole.temperature_period_s;
  part.temperature_step_degc = whole.temperature_step_degc;
  for (const ColumnInfo& info : kColumns) part[info.column] = rows_of(whole[info.column], rows);
  part.temperature_is_read = rows_of(whole.temperature_is_read, rows);
  for (const Recording::Label& label : whole.labels) {
    if (label.first_row >= rows.end) break;
    const std::size_t row = std::max(label.first_row, rows.first) - rows.first;
    if (row == 0) part.labels.clear();
    part.labels.push_back({row, label.text});
  }
  return part;
}

}  // namespace

LongRecording::LongRecording(const ReadOptions& options, std::size_t min_rows)
    : options_(&options), part_rows_(kMaxRows) {
  if (options.every_row || min_rows <= kMaxRows) return;
  rows_per_mean_ = 1;
  part_rows_ = rules::kPartRows;
}

void LongRecording::take(Recording& part, LineNumbers& lines, const std::string& where) {
  if (options_->every_row) {
    throw InputError(where, format("more than %zu million samples, each of which is needed here; "
                                   "cut the file",
                                   kMaxRows / 1'000'000));
  }
  rows_per_mean_ = std::max<std::size_t>(rows_per_mean_, 1);
  part_rows_ = rules::kPartRows;
  if (part.rows() <= part_rows_) {
    take_part(part, lines);
    for (const ColumnInfo& info : kColumns) part[info.column].clear();
    part.temperature_is_read.clear();
    part.labels.clear();
    lines = {};
    return;
  }
  std::size_t first = 0;
  for (; first + part_rows_ <= part.rows(); first += part_rows_) {
    Recording slice = rows_of(part, {first, first + part_rows_});
    take_part(slice, lines.from(first));
  }
  Recording rest = rows_of(part, {first, part.rows()});
  for (const ColumnInfo& info : kColumns) part[info.column] = std::move(rest[info.column]);
  part.temperature_is_read.clear();  // as rows from the file: further ones follow
  part.labels = std::move(rest.labels);
  lines = lines.from(first);
}

void LongRecording::take_part(Recording& part, const LineNumbers& lines) {
  read_rows_ += part.rows();
  if (leave_out_refused(part, lines)) {
    find_stretches(part);
    if (period_s_ == 0) period_s_ = part.period_s;
    match_columns(part);
    const std::vector<std::size_t> breaks = breaks_of(part);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) add_means(part, breaks[i], breaks[i + 1]);
    while (means_.rows() > rules::kMaxMeanRows) halve();
  }
  means_.power_on_unknown = part.power_on_unknown;
  means_.temperature_period_s = part.temperature_period_s;
  means_.temperature_step_degc = part.temperature_step_degc;
}

// Counts for the whole file; false if no row of this part is left.
bool LongRecording::leave_out_refused(Recording& part, const LineNumbers& lines) {
  ReadWatch watch;
  watch.remark = [&](const std::string& line) {
    if (first_refusal_.empty()) first_refusal_ = line;
  };
  const std::size_t rows = part.rows();
  try {
    find_stretches(part);
    leave_out_refused_rows(part, lines, options_->limits.over(options_->model_limits), watch);
  } catch (const InputError& error) {  // none of its rows is acceptable for a board
    if (first_refusal_.empty()) first_refusal_ = error.what();
    means_.refused_rows += rows;
    return false;
  }
  means_.refused_rows += rows - part.rows();
  return part.rows() > 0;
}

// A column that begins later had its first value before, like an extension record; a column that
// ends is removed from the whole recording.
void LongRecording::match_columns(const Recording& part) {
  for (const ColumnInfo& info : kColumns) {
    std::vector<double>& column = means_[info.column];
    if (part[info.column].empty()) {
      column.clear();
    } else if (column.empty()) {
      column.assign(means_.rows(), part[info.column].front());
    }
  }
}

void LongRecording::add_means(const Recording& part, std::size_t first, std::size_t end) {
  for (const Recording::Label& label : part.labels) {
    const bool goes_on = !means_.labels.empty() && means_.labels.back().text == label.text;
    if (label.first_row == first && !goes_on) means_.labels.push_back({means_.rows(), label.text});
  }
  for (std::size_t row = first; row < end; row += rows_per_mean_) {
    const std::size_t last = std::min(row + rows_per_mean_, end);
    for (const ColumnInfo& info : kColumns) {
      if (part[info.column].empty()) continue;
      means_[info.column].push_back(mean_of(part[info.column], row, last));
    }
    means_.temperature_is_read.push_back(any_read(part.temperature_is_read, row, last));
  }
}

// From now on means have twice as many rows; two neighbours of the present ones are joined.
void LongRecording::halve() {
  const double spacing_s = period_s_ * static_cast<double>(rows_per_mean_);
  std::vector<std::size_t> starts;
  for (std::size_t row = 0; row < means_.rows();) {
    starts.push_back(row);
    const std::size_t next = row + 1;
    const bool neighbours = next < means_.rows() && !starts_label(means_, next) &&
                            !is_gap(means_.time_s[next] - means_.time_s[row], spacing_s);
    row += neighbours ? 2 : 1;
  }
  merge(starts);
  rows_per_mean_ *= 2;
}

void LongRecording::merge(const std::vector<std::size_t>& starts) {
  for (Recording::Label& label : means_.labels) {
    label.first_row = static_cast<std::size_t>(
        std::lower_bound(starts.begin(), starts.end(), label.first_row) - starts.begin());
  }
  const auto end_of = [&](std::size_t i, std::size_t rows) {
    return i + 1 < starts.size() ? starts[i + 1] : rows;
  };
  for (const ColumnInfo& info : kColumns) {
    std::vector<double>& column = means_[info.column];
    if (column.empty()) continue;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      column[i] = mean_of(column, starts[i], end_of(i, column.size()));
    }
    column.resize(starts.size());
    column.shrink_to_fit();
  }
  std::vector<bool>& is_read = means_.temperature_is_read;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    is_read[i] = any_read(is_read, starts[i], end_of(i, is_read.size()));
  }
  is_read.resize(starts.size());
}

Recording LongRecording::finish(const std::string& file) {
  if (means_.rows() == 0) throw InputError(file, "no sample is left: " + first_refusal_);
  means_.file = file;
  if (means_.refused_rows > 0) {
    options_->watch.say(file, counted(means_.refused_rows, "sample") +
                                  " left out by the board's rules, the first: " + first_refusal_);
  }
  options_->watch.say(
      file, format("%zu samples: read in means of %zu (%.4g s), %zu of them", read_rows_,
                   rows_per_mean_, period_s_ * static_cast<double>(rows_per_mean_), means_.rows()));
  means_.rows_per_row = rows_per_mean_;
  return std::move(means_);
}

}  // namespace fogcomp::recording
