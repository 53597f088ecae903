#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/column_map.hpp"
#include "recording/columns.hpp"
#include "recording/csv_layout.hpp"
#include "recording/csv_row.hpp"
#include "recording/long_recording.hpp"
#include "recording/row_filter.hpp"
#include "recording/row_range.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

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

// Seconds that a time counter of 16, 24 or 32 bits, or a clock, lost at `time_s` where it began
// again, so that the rows go on as before; 0 if it did not.
double wrapped_s(const CsvLayout& layout, double previous_s, double spacing_s, double time_s) {
  if (layout.time != TimeFormat::number) return 0;
  const Unit unit = layout.header.unit_of(kTimeSlot);
  const double day_s = 24 * kSecondsPerHour;
  for (const double span_s :
       {unit.convert(0x1p16), unit.convert(0x1p24), unit.convert(0x1p32), day_s, 7 * day_s}) {
    const double step_s = time_s + span_s - previous_s;
    if (step_s > 0 && !is_gap(step_s, spacing_s)) return span_s;
  }
  return 0;
}

/// Whether a last line without its end may have been cut within a number.
class CutLine {
 public:
  CutLine(const CsvLayout& layout, const FileHead& head)
      : dialect_(layout.dialect), is_read_(layout.header.slots.back() < CsvHeader::kReadSlots) {
    for_each_row(first_lines(head), layout, [&](std::size_t, const auto& fields) {
      longest_ = std::max(longest_, fields.back().size());
      longest_fraction_ = std::max(longest_fraction_, fraction_of(fields.back()));
    });
  }

  // What is wrong with `line`, or nothing: a number that is cut has fewer digits than others.
  std::string fault_of(std::string_view line) const {
    std::vector<std::string_view> fields;
    split_fields(line, dialect_.separator, fields);
    const std::string_view number = fields.back();
    const bool is_shorter =
        longest_fraction_ > 0 ? fraction_of(number) < longest_fraction_ : number.size() < longest_;
    if (!is_read_ || !is_shorter || line.back() == '"') return {};
    return "the file ends within a line, and '" + printable(number) +
           "' has fewer digits than others: it may be cut (if not, end the line)";
  }

 private:
  // Length from the decimal mark on; 0 without one.
  std::size_t fraction_of(std::string_view number) const {
    const std::size_t mark = number.find(dialect_.decimal_mark());
    return mark == std::string_view::npos ? 0 : number.size() - mark;
  }

  CsvDialect dialect_;
  bool is_read_;
  std::size_t longest_ = 0;
  std::size_t longest_fraction_ = 0;
};

/// The rows that cannot be read, of which a file may have few.
class BadRows {
 public:
  std::size_t count() const { return count_; }
  std::string first_at_line() const { return "line " + std::to_string(line_) + ", " + fault_; }
  /// The row just read, one of `rows`; `cure`: of the first one, other than to leave it out.
  void add(const InputFile& file, std::size_t rows, const std::string& fault,
           const std::string& cure = "") {
    if (count_++ == 0) {
      where_ = file.where();
      line_ = file.line_number();
      fault_ = fault;
      cure_ = cure;
    }
    run_ = rows - last_ == 1 ? run_ + 1 : 1;
    last_ = rows;
    longest_run_ = std::max(longest_run_, run_);
  }

  /// Before add(): a time that lies back. Rows that go on from there are of a clock that was set.
  void add_time(double time_s, std::size_t rows) {
    if (count_ > 0 && time_s < back_s_ && 2 * ++falls_ > rows) {
      cure_ = "the newest row stands first: sort the rows by time";
    }
    goes_on_ = time_s > back_s_ ? goes_on_ + 1 : 0;
    back_s_ = time_s;
    if (goes_on_ > kFewValues) was_set_back_ = true;
  }

  static bool are_few(std::size_t bad, std::size_t rows) {
    return bad <= kFewValues || static_cast<double>(bad) <= kNoticeable * static_cast<double>(rows);
  }

  /// They are left out where they are few, so that the others are read as they are meant.
  void judge(const InputFile& file, std::size_t rows, bool skipped, bool none_is_good) const {
    if (count_ == 0) return;
    const std::string share = std::to_string(count_) + " of " + counted(rows, "row");
    const bool are_most = 2 * count_ > rows;
    if (skipped && none_is_good) {
      throw InputError(file.path(), "has no good row; the first bad one: " + first_at_line());
    }
    const bool has_cure = !cure_.empty() && !are_few(count_, rows);
    if (skipped && (are_most || was_set_back_ || has_cure)) {
      throw InputError(where_, fault_ + "; " + share + " would be left out: correct the file" +
                                   (cure_.empty() ? "" : "; " + cure_));
    }
    if (skipped) return;
    const bool is_small = !are_most && longest_run_ <= kFewValues && are_few(count_, rows);
    const std::string remedy = !cure_.empty() ? cure_
                               : is_small     ? "correct the line or give --skip-bad-rows"
                                              : share + " are bad: correct the file";
    throw InputError(where_, fault_ + "; " + remedy);
  }

 private:
  std::size_t count_ = 0;
  std::string where_;  // of the first
  std::string fault_;
  std::size_t line_ = 0;
  std::string cure_;
  std::size_t last_ = 0;
  std::size_t run_ = 0;
  std::size_t longest_run_ = 0;
  double back_s_ = -std::numeric_limits<double>::infinity();  // time of the last row that lies back
  std::size_t falls_ = 0;    // rows before the one that lies back before them
  std::size_t goes_on_ = 0;  // rows after it that rise
  bool was_set_back_ = false;
};

/// Collects the good rows of a Recording and counts the bad ones.
class RowCollector {
 public:
  RowCollector(const CsvLayout& layout, const InputFile& file, const ReadOptions& options,
               LineNumbers& lines, const RowMarks& marks, std::size_t min_rows)
      : reader_(layout),
        layout_(layout),
        file_(file),
        options_(options),
        lines_(lines),
        marks_(marks),
        long_recording_(options, min_rows),
        are_counts_(layout.header.unit_of(kRateSlot).quantity == Quantity::counts) {
    recording_.file = file.path();
    recording_.power_on_unknown = !layout.knows_power_on();
    for (const std::size_t slot : layout.header.slots) {
      if (slot < kColumns.size()) columns_.push_back({slot, &(recording_[kColumns[slot].column])});
    }
    if (!layout.header.has(kTimeSlot)) {
      period_s_ = options.is_table ? kDwellSpacingS : 1 / *options.stream_rate_hz;
      columns_.push_back({kTimeSlot, &recording_.time_s});
    }
    for (const CsvHeader::Constant& each : layout.header.constants) {
      constants_.push_back(each);
      columns_.push_back({each.slot, &(recording_[kColumns[each.slot].column])});
    }
    if (layout.header.is_constant(kTemperatureSlot)) recording_.temperature_period_s = HUGE_VAL;
  }

  /// Reserves memory for all rows of a file of `bytes`, estimated from the length of one row:
  /// growing would copy every column several times.
  void reserve(std::size_t bytes, std::size_t bytes_of_line) {
    const std::size_t rows = std::min(bytes / (bytes_of_line + 1) + 1, long_recording_.part_rows());
    for (const auto& [slot, values] : columns_) values->reserve(rows);
  }

  // `cut`: where the line may not be whole.
  void add(std::string_view line, const CutLine* cut) {
    CsvRow row;
    const std::size_t number = rows_read_++;
    if (!reader_.read(line, row)) return refuse_text(line);
    const std::string fault_of_end = cut != nullptr ? cut->fault_of(line) : std::string();
    if (!fault_of_end.empty()) return refuse(fault_of_end);
    if (period_s_ > 0) row.values[kTimeSlot] = static_cast<double>(number) * period_s_;
    for (const CsvHeader::Constant& each : constants_) row.values[each.slot] = each.value;
    if (row.lacks_values && lacks_needed(row)) return;
    if (has_waiting_) take_waiting(row);
    for (const auto& [slot, values] : columns_) {
      const double value = row.values[slot];
      const bool is_asked = slot == kRateSlot && are_counts_;
      if (!is_asked && !kColumns[slot].can_be(value) && !std::isnan(value)) {
        return refuse(fault_of_range(slot, row));
      }
    }
    double time_s = row.values[kTimeSlot] + wrapped_s_;
    if (!(time_s > previous_s_)) {
      const double wrap_s = wrapped_s(layout_, previous_s_, spacing_s_, time_s);
      time_s += wrap_s;
      wrapped_s_ += wrap_s;
      if (wrap_s > 0) ++wraps_;
    }
    if (!(time_s > previous_s_) && !is_taken_as_repeat(time_s, row)) {
      return refuse_time(line, time_s);
    }
    if (recording_.rows() == long_recording_.part_rows()) hand_over();
    row.values[kTimeSlot] = time_s;
    if (std::isinf(previous_s_)) {
      first_s_ = time_s;
    } else {
      spacing_s_ = time_s - previous_s_;
    }
    previous_s_ = time_s;
    lines_.add(recording_.rows(), file_.line_number());
    if (!row.label.empty() || !recording_.labels.empty()) add_label(row.label);
    for (const auto& [slot, values] : columns_) values->push_back(row.values[slot]);
    sparse_ = sparse_ || row.lacks_values;
  }

  Recording finish() {
    const bool none = recording_.rows() == 0 && long_recording_.rows_taken() == 0;
    bad_.judge(file_, rows_read_, options_.skip_bad_rows, none);
    recording_.bad_rows = bad_.count();
    if (none) {
      fail(recording_.empty_rows > 0 ? "has no sample with a time and a rate"
                                     : "has a header but no samples");
    }
    const auto say_of = [&](std::size_t count, const char* what, const std::string& words) {
      if (count > 0) say(counted(count, what) + words);
    };
    say_of(recording_.empty_rows, "sample",
           " left out: no time or rate, the first at line " + std::to_string(first_empty_));
    say_of(moved_, "row", " without a rate: the other values count from the next sample on");
    say_of(recording_.bad_rows, "bad row", " left out, the first: " + bad_.first_at_line());
    if (wraps_ > 0) {
      say("its time counter began again " + counted(wraps_, "time") + ": counted on");
    }
    complete();
    refuse_doubted_units();
    recording_.first_date_s = reader_.first_date_s();
    if (!long_recording_.begun()) return std::move(recording_);
    if (!options_.join.empty()) {
      fail("is too long for --join; join parts of it by fogcomp convert");
    }
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

  [[noreturn]] void fail(const std::string& what) const { throw InputError(file_.path(), what); }
  void say(const std::string& what) const { options_.watch.say(file_.path(), what); }

  void refuse_doubted_units() {
    if (!long_recording_.begun()) refuse_doubted_time();
    const std::string signs = fault_of_signs(recording_.rate_dph, layout_.header);
    if (!signs.empty()) fail(signs);
    if (layout_.header.input_rate_is_chosen) return;
    const std::string input = fault_of_input_rate(recording_, layout_.header);
    if (!input.empty()) fail(input);
  }

  // A unit that no name gives is asked for if figures speak against seconds.
  void refuse_doubted_time() {
    const CsvHeader& header = layout_.header;
    if (!header.has(kTimeSlot) || header.time_has_unit || layout_.time != TimeFormat::number ||
        !header.unit_of(kTimeSlot).is_ours()) {
      return;
    }
    find_stretches(recording_);
    const std::string doubt = doubt_of_time(recording_);
    if (doubt.empty()) return;
    fail("its time has no unit, and in s " + doubt +
         " Give it: --columns 'time=" + column_choice(header.names, header.field_of(kTimeSlot)) +
         "[min]', or '[s]' if it is right, or '[h]' or '[ms]'");
  }

  // Each part of a long recording.
  void complete() {
    if (!options_.is_table) even_out_times();
    complete_sparse();
    if (options_.every_row || options_.is_table) return;
    leave_out_repeats();
  }

  // Of a file with times.
  std::optional<double> given_rate_hz() const {
    return period_s_ > 0 ? std::nullopt : options_.stream_rate_hz;
  }

  void even_out_times() {
    leave_out_doubled();
    auto even = even_times(recording_.time_s, given_rate_hz());
    const bool is_counted = given_rate_hz() && !first_repeat_.empty() && !(even && even->is_known);
    auto counted_s = is_counted ? counted_times(recording_.time_s, *given_rate_hz())
                                : std::optional<std::vector<double>>();
    if (counted_s) {
      say("times of a coarse clock; samples are counted, " +
          format("%g in a second as given", *given_rate_hz()));
      recording_.time_s = std::move(*counted_s);
      first_repeat_ = {};
    } else if (even && even->is_known) {
      say(
          format("times are those at which samples arrived; taken as even, at %.8g +- %.2g Hz: "
                 "%zu uneven spacings, %s",
                 even->rate_hz, even->rate_sigma_hz, even->uneven_before,
                 counted(even->gaps_after, "gap").c_str()));
      recording_.time_s = std::move(even->time_s);
      first_repeat_ = {};
    } else if ((even && even->uneven_before > repeats_) || is_counted) {
      refuse_times();
    } else if (!first_repeat_.empty()) {
      refuse_repeats();
    }
    repeats_ = 0;
    doubled_.clear();
  }

  [[noreturn]] void refuse_times() const {
    fail(given_rate_hz() ? format("times do not go with %g samples a second: too many, or too "
                                  "late; give another --rate",
                                  *given_rate_hz())
                         : "times are those at which samples arrived, and do not tell the sample "
                           "rate: too many are lost or late; give --rate HZ");
  }

  [[noreturn]] void refuse_repeats() const {
    const bool are_few = BadRows::are_few(repeats_, recording_.rows());
    throw InputError(
        first_repeat_.where,
        first_repeat_.fault + (are_few ? "; correct the line or give --skip-bad-rows"
                                       : "; give --rate HZ, and the samples are counted"));
  }

  // If all rows of one time are: a clock that is too coarse would show different samples.
  void leave_out_doubled() {
    if (repeats_ == 0 || doubled_.size() != repeats_) return;
    say(counted(repeats_, "row") + " left out that repeat the one before, time and values");
    remove_rows(recording_, lines_, doubled_);
    first_repeat_ = {};
  }

  void leave_out_repeats() {
    const std::vector<std::size_t> repeats = repeated_readings(recording_.rate_dph);
    if (repeats.empty()) return;
    say(
        format("rate_dph repeats each reading until the next one: %zu readings in %zu samples; "
               "repeats are left out",
               recording_.rows() - repeats.size(), recording_.rows()));
    remove_rows(recording_, lines_, repeats);
    auto even = even_times(recording_.time_s);
    if (even && even->is_known) recording_.time_s = std::move(even->time_s);
  }

  void complete_sparse() {
    Recording& run = recording_;
    const bool is_held = blank_held_readings(run.time_s, run.rate_dph, run.input_rate_dph);
    const bool is_slow = !options_.keep_refused_rows &&  // a board holds it, too
                         blank_held_temperatures(run.time_s, run.temperature_degc);
    const char* const repeats = " repeats each reading until the next one";
    if (is_held) say(std::string("input_rate_dph") + repeats);
    if (is_slow) say(std::string("temperature_degc") + repeats);
    if (sparse_ || is_held || is_slow) {
      complete_sparse_columns(recording_, lines_, options_.watch, is_slow);
    }
    sparse_ = false;
  }

  void hand_over() {
    complete();
    long_recording_.take(recording_, lines_, file_.where());
    for (const auto& [slot, values] : columns_) values->reserve(long_recording_.part_rows());
  }

  // A row needs time and rate; other values are completed later. What a row without a rate has
  // waits for the next one.
  bool lacks_needed(const CsvRow& row) {
    const bool has_time = !std::isnan(row.values[kTimeSlot]);
    if (has_time && !std::isnan(row.values[kRateSlot])) return false;
    bool any = false;
    for (const auto& [slot, values] : columns_) {
      if (!has_time || slot == kTimeSlot || std::isnan(row.values[slot])) continue;
      if (!kColumns[slot].can_be(row.values[slot])) continue;
      if (!has_waiting_) waiting_.values.fill(std::numeric_limits<double>::quiet_NaN());
      waiting_.values[slot] = row.values[slot];
      has_waiting_ = any = true;
    }
    if (any) {
      waiting_.values[kTimeSlot] = row.values[kTimeSlot];
      ++moved_;
    } else if (recording_.empty_rows++ == 0) {
      first_empty_ = file_.line_number();
    }
    return true;
  }

  void take_waiting(CsvRow& row) {
    has_waiting_ = false;
    const double waited_s = row.values[kTimeSlot] - waiting_.values[kTimeSlot];
    if (waited_s < 0 || waited_s > kHoldSeconds) return;
    for (const auto& [slot, values] : columns_) {
      if (std::isnan(row.values[slot])) row.values[slot] = waiting_.values[slot];
    }
  }

  // Rows of one time may be samples of a coarse clock, or one row that stands there twice.
  bool is_taken_as_repeat(double time_s, const CsvRow& row) {
    if (time_s != previous_s_ || options_.skip_bad_rows) return false;
    if (first_repeat_.empty()) {
      first_repeat_ = {file_.where(),
                       fault_of_time(first_s_, previous_s_, time_s, recording_.power_on_unknown)};
    }
    ++repeats_;
    const bool is_same = std::all_of(columns_.begin(), columns_.end(), [&](const Target& each) {
      const double value = row.values[each.slot];
      if (each.slot == kTimeSlot || each.values->empty()) return each.slot == kTimeSlot;
      return each.values->back() == value || (std::isnan(each.values->back()) && std::isnan(value));
    });
    if (is_same) doubled_.push_back(recording_.rows());
    return true;
  }

  void refuse_text(std::string_view line) {
    const std::vector<std::string> names = names_in(line, layout_.dialect.separator);
    const bool is_header = names.size() > 1 && std::none_of(names.begin(), names.end(), is_value) &&
                           !is_units_row(names) && names != layout_.header.names &&
                           required_columns_among(names, options_) > 1;
    if (is_header) {
      throw InputError(file_.where(), rows_read_ == 1
                                          ? "names or units below the header; delete this line"
                                          : "another header; split the file at this line");
    }
    refuse(reader_.fault_of(line), bad_.count() == 0 ? reader_.cure_of(line) : "");
  }

  void refuse_time(std::string_view line, double time_s) {
    const std::string run = bad_.count() == 0 ? marks_.run_before(line, file_.line_number()) : "";
    bad_.add_time(time_s, rows_read_);
    refuse(fault_of_time(first_s_, previous_s_, time_s, recording_.power_on_unknown),
           run.empty() ? "" : run + " takes the rows before it");
  }

  void refuse(const std::string& fault, const std::string& cure = "") {
    bad_.add(file_, rows_read_, fault, cure);
  }

  void add_label(std::string_view label) {
    if (label == last_label_ && !recording_.labels.empty()) return;
    last_label_ = label;
    recording_.labels.push_back({recording_.rows(), displayable(label)});
  }

  CsvRowReader reader_;
  const CsvLayout& layout_;
  const InputFile& file_;
  const ReadOptions& options_;
  LineNumbers& lines_;
  const RowMarks& marks_;
  Recording recording_;
  LongRecording long_recording_;
  std::vector<Target> columns_;
  std::vector<CsvHeader::Constant> constants_;
  std::size_t rows_read_ = 0;
  double period_s_ = 0;  // of a file without times
  double first_s_ = 0;
  double previous_s_ = -std::numeric_limits<double>::infinity();
  double spacing_s_ = 0;  // of the two rows before
  double wrapped_s_ = 0;
  std::size_t wraps_ = 0;
  // The first row with the time of the one before.
  struct Repeat {
    std::string where;
    std::string fault;
    bool empty() const { return where.empty(); }
  } first_repeat_;
  std::size_t repeats_ = 0;           // rows with the time of the one before
  std::vector<std::size_t> doubled_;  // those that have its values, too
  BadRows bad_;
  CsvRow waiting_{};  // values of rows without a rate
  bool has_waiting_ = false;
  std::size_t moved_ = 0;
  bool are_counts_;              // the rates: what they can be is asked when their signs are known
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
  const FileHead file_head{head, file.at_end(), file.is_utf16(), file.path()};
  const CsvLayout layout = find_csv_layout(file_head, options);
  const CutLine cut(layout, file_head);
  RowMarks marks(first_lines(file_head), layout);
  RowCollector collector(layout, file, options, lines, marks, min_rows_of(file, head));
  for (std::size_t i = 0; i < layout.lines_before_rows; ++i) file.next_line(line);
  bool reserved = false;
  RowFilter filter(layout, options, file.path());
  while (file.next_line(line)) {
    if (is_comment_or_blank(line)) continue;
    if (!filter.takes_all() && !filter.takes(line)) continue;
    if (!reserved) collector.reserve(file.size(), line.size());
    reserved = true;
    if (marks.has_flag()) marks.see(line);
    collector.add(line, file.lacks_line_end() ? &cut : nullptr);
  }
  if (filter.left_out() > 0) {
    options.watch.say(file.path(),
                      counted(filter.left_out(), "row") + " of other sensors left out");
  }
  if (const std::string flag = marks.flag_words(); !flag.empty()) {
    options.watch.say(file.path(), flag);
  }
  return collector.finish();
}

}  // namespace fogcomp::recording
