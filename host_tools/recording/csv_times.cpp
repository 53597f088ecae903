#include "recording/csv_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "recording/column_map.hpp"
#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

/// The times of the first rows.
class TimeColumn {
 public:
  TimeColumn(const std::vector<std::string_view>& lines, const std::string& path, CsvLayout& layout)
      : lines_(lines), path_(path), layout_(layout) {}

  void understand() {
    if (!layout_.header.has(kTimeSlot)) return;
    choose_day_order();
    const std::vector<TimeReading> numbers = read_numbers();
    if (numbers.empty()) return;
    if (!parts_fit_) refuse_parts();
    refuse_clock(numbers);
    const TimesSeen times = seen(numbers);
    if (!layout_.header.time_has_unit) choose_unit(times);
    const Unit unit = layout_.header.unit_of(kTimeSlot);
    layout_.scale = scale_of(times.first, unit);
    if (!is_since_power_on(times.first, unit)) layout_.time = TimeFormat::dates;
    if (layout_.time == TimeFormat::number && first_s_.value_or(0) > 0) {
      layout_.header.understood.push_back(format(
          "power-on is %g s before the first sample (of a clock, it is not known: add its date)",
          *first_s_));
    }
  }

 private:
  // Of dates with the year behind, the order that all of them have.
  void choose_day_order() {
    CsvHeader& header = layout_.header;
    std::string example;
    bool day_first = true;
    bool month_first = true;
    for_each_row(lines_, layout_, [&](std::size_t, const auto& fields) {
      if (fields.size() < header.slots.size()) return;
      const std::string_view text = header.time_of(fields, both_);
      if (read_calendar_time(text) || calendar_part(text) != CalendarPart::both) return;
      if (example.empty()) example = text;
      day_first = day_first && read_calendar_time(text, DayOrder::day_first);
      month_first = month_first && read_calendar_time(text, DayOrder::month_first);
    });
    if (example.empty() || header.day_order != DayOrder::unknown) return;
    if (day_first == month_first) refuse_order(example, day_first);
    header.day_order = day_first ? DayOrder::day_first : DayOrder::month_first;
  }

  [[noreturn]] void refuse_order(const std::string& example, bool may_be_both) const {
    const CsvHeader& header = layout_.header;
    const bool is_apart = header.calendar.size() == 2;
    const std::string time = column_choice(header.names, header.field_of(kTimeSlot));
    const std::string date = is_apart ? column_choice(header.names, header.calendar[0]) : time;
    const std::string rest = (is_apart ? "+" + time : "") + "'";
    const std::string where = path_ + ": times such as " + printable(example);
    if (!may_be_both) {
      throw InputError(where +
                       " have the day first in some rows and the month in others; write "
                       "2024-03-05T12:30:15");
    }
    throw InputError(where + " can have the day or the month first; say which: --columns 'time=" +
                     date + "[D/M/Y]" + rest + " or 'time=" + date + "[M/D/Y]" + rest);
  }

  // Empty if the first time is a date, or if there is none.
  std::vector<TimeReading> read_numbers() {
    std::vector<TimeReading> numbers;
    const CsvHeader& header = layout_.header;
    std::size_t dates = 0;  // among the numbers: "20240305080000"
    double none = 0;
    std::size_t line_of_text = 0;
    std::string other;
    for_each_row(lines_, layout_, [&](std::size_t line, const auto& fields) {
      if (layout_.time == TimeFormat::calendar || fields.size() < header.slots.size()) return;
      const std::string_view text = header.time_of(fields, both_);
      const bool is_date = read_calendar_time(text, header.day_order).has_value();
      if (const auto number = read_long_number(text, layout_.dialect)) {
        numbers.push_back(*number);
        if (is_date) ++dates;
        check_parts(*number, fields);
      } else if (numbers.empty() && is_date) {
        layout_.time = TimeFormat::calendar;
      } else if (numbers.empty() && line_of_text == 0 && is_elapsed(text)) {
        layout_.time = TimeFormat::calendar;
        layout_.header.day_order = DayOrder::no_date;
      } else if (read_number(text, layout_.dialect, none) == FieldKind::text && line_of_text == 0) {
        line_of_text = line + 1;
        other = text;
      }
    });
    if (layout_.time == TimeFormat::calendar) return {};
    if (numbers.empty() && line_of_text > 0) {
      throw InputError(path_ + ":" + std::to_string(line_of_text),
                       "time '" + printable(other) +
                           "' is no date and time; write 2024-03-05T12:30:15.25 or seconds");
    }
    const bool are_dates = dates > 0 && dates == numbers.size();
    if (!are_dates || !header.unit_of(kTimeSlot).is_ours()) return numbers;
    layout_.time = TimeFormat::calendar;
    return {};
  }

  // A clock that begins at 0:00:00 counts from there; another one is refused without a date.
  bool is_elapsed(std::string_view text) const {
    const auto clock = read_calendar_time(text, DayOrder::no_date);
    return layout_.header.calendar.empty() && clock && clock->whole == 0;
  }

  // Parts are added to whole numbers, and each is less than one of those before it.
  void check_parts(const TimeReading& time, const std::vector<std::string_view>& fields) {
    const CsvHeader& header = layout_.header;
    bool is_whole = time.fraction == 0;
    double unit_s = header.unit_of(kTimeSlot).convert(1);
    double sum_s = unit_s * static_cast<double>(time.whole);
    for (std::size_t slot = CsvHeader::kTimePart; header.has(slot); ++slot) {
      const std::size_t field = header.field_of(slot);
      double part = 0;
      if (field >= fields.size() ||
          read_number(fields[field], layout_.dialect, part) != FieldKind::number) {
        return;
      }
      const double part_s = header.unit_of(slot).convert(part);
      sum_s += part_s;
      if (!is_whole || part_s < 0 || part_s >= unit_s) parts_fit_ = false;
      is_whole = part == std::floor(part);
      unit_s = header.unit_of(slot).convert(1);
    }
    if (!first_s_ && header.has(CsvHeader::kTimePart)) first_s_ = sum_s;
  }

  [[noreturn]] void refuse_parts() const {
    const CsvHeader& header = layout_.header;
    std::vector<std::string> names{column_choice(header.names, header.field_of(kTimeSlot))};
    for (std::size_t slot = CsvHeader::kTimePart; header.has(slot); ++slot) {
      names.push_back(column_choice(header.names, header.field_of(slot)));
    }
    throw InputError(path_, "'" + join(names, "' and '") +
                                "' are no time in parts (whole numbers, and less than one of "
                                "them): say which is the time: --columns 'time=" +
                                join(names, "' or 'time=") + "'");
  }

  void refuse_clock(const std::vector<TimeReading>& numbers) const {
    std::vector<double> times;
    for (const TimeReading& each : numbers) {
      times.push_back(each.number());
    }
    if (!layout_.header.unit_of(kTimeSlot).is_ours() || !are_of_clock(times)) return;
    throw InputError(path_, times_such_as(times.front()) +
                                " are hhmmss of a clock; write 2024-03-05T12:30:15.25 or seconds");
  }

  std::string times_such_as(double number) const {
    const std::size_t field = layout_.header.field_of(kTimeSlot);
    return format("times such as %.15g (column %zu '", number, field + 1) +
           printable(layout_.header.names[field]) + "')";
  }

  static TimesSeen seen(const std::vector<TimeReading>& numbers) {
    TimesSeen times{numbers[0].number()};
    times.are_whole = std::all_of(numbers.begin(), numbers.end(),
                                  [](const TimeReading& each) { return each.fraction == 0; });
    std::vector<double> spacings;
    double sum = 0;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const double spacing = numbers[i].since(numbers[i - 1]);
      if (spacing < 0) continue;  // begins again
      spacings.push_back(spacing);
      sum += spacing;
    }
    if (spacings.empty()) return times;
    times.mean_spacing = sum / static_cast<double>(spacings.size());
    times.median_spacing = median(std::move(spacings));
    return times;
  }

  void choose_unit(const TimesSeen& times) {
    const std::vector<TimeMeaning> meanings = possible_meanings(times);
    if (meanings.size() != 1) refuse(times, meanings);
    CsvHeader& header = layout_.header;
    const Unit& unit = meanings[0].unit;
    const bool is_doubtful =
        unit.is_ours() && meanings[0].scale == nullptr && may_be_milliseconds(times);
    if (!unit.is_ours()) header.conversions.push_back({kTimeSlot, unit});
    for (std::string& each : header.understood) {
      if (each.rfind("time: ", 0) != 0) continue;
      each = each.substr(0, each.rfind(' ') + 1) + unit.words;
      if (is_doubtful) each += format(" (in ms: a sample each %.4g s)", times.mean_spacing / 1e3);
    }
  }

  [[noreturn]] void refuse(const TimesSeen& times, const std::vector<TimeMeaning>& meanings) const {
    const CsvHeader& header = layout_.header;
    const std::string name = column_choice(header.names, header.field_of(kTimeSlot));
    std::vector<std::string> words;
    std::vector<std::string> choices;
    for (const TimeMeaning& meaning : meanings) {
      words.push_back(meaning_words(meaning, times));
      choices.push_back("'time=" + name + "[" + meaning.unit.words + "]'");
    }
    throw InputError(
        path_, times_such_as(times.first) +
                   (meanings.empty()
                        ? " give no possible date or period in s, ms, us, ns, 100 ns or days; give "
                          "their unit: --columns 'time=" +
                              name + "[UNIT]'"
                        : " can be in " + join(words, ", or in ") + "; say which: --columns " +
                              join(choices, " or ")));
  }

  const std::vector<std::string_view>& lines_;
  const std::string& path_;
  CsvLayout& layout_;
  bool parts_fit_ = true;          // of a time in several columns
  std::optional<double> first_s_;  // of those
  std::string both_;               // a date and a time of day
};

/// The first and the last of times that rise in all rows.
struct RisingTimes {
  std::size_t rows = 0;
  double first_s = 0;
  double last_s = 0;
  bool is_rising = true;

  void add(double time_s) {
    is_rising = is_rising && (rows == 0 || time_s > last_s);
    if (rows++ == 0) first_s = time_s;
    last_s = time_s;
  }
  double length_s() const { return last_s - first_s; }
};

// Of the time, another one and their sum, over the rows in which both fields have numbers.
std::array<RisingTimes, 3> rising_times(const std::vector<std::string_view>& lines,
                                        const CsvLayout& layout, std::size_t other,
                                        const Unit& unit) {
  const std::size_t time = layout.header.field_of(kTimeSlot);
  std::array<RisingTimes, 3> times;
  for_each_row(lines, layout, [&](std::size_t, const auto& fields) {
    if (fields.size() <= std::max(time, other)) return;
    const auto one = read_long_number(fields[time], layout.dialect);
    const auto two = read_long_number(fields[other], layout.dialect);
    if (!one || !two) return;
    const double one_s = layout.header.unit_of(kTimeSlot).convert(one->number());
    const double two_s = unit.convert(two->number());
    times[0].add(one_s);
    times[1].add(two_s);
    times[2].add(one_s + two_s);
  });
  return times;
}

}  // namespace

void refuse_second_times(const std::vector<std::string_view>& lines, const std::string& path,
                         const CsvLayout& layout) {
  const CsvHeader& header = layout.header;
  if (!header.has(kTimeSlot) || header.time_is_chosen) return;
  const std::size_t time = header.field_of(kTimeSlot);
  const std::size_t close = std::min(header.names.size(), rules::kMaxColumnsUnderstood);
  for (std::size_t i = 0; i < close; ++i) {
    if (header.slots[i] != CsvHeader::kIgnored) continue;
    const auto meaning = ColumnName(header.names[i]).meaning();
    if (!meaning || meaning->slot != kTimeSlot) continue;
    if (meaning->unit.has_value() != ColumnName(header.names[time]).unit.has_value()) continue;
    const Unit unit = meaning->unit ? *meaning->unit : header.unit_of(kTimeSlot);
    const auto [own, other, sum] = rising_times(lines, layout, i, unit);
    const bool are_parts = !own.is_rising && sum.is_rising && sum.rows >= kFewValues;
    if (are_parts) {
      const std::string name = column_choice(header.names, time);
      const std::string further = column_choice(header.names, i);
      const bool is_finer = unit.convert(1) < header.unit_of(kTimeSlot).convert(1);
      throw InputError(path, "its time is in parts, '" + name + "' and '" + further +
                                 "'; give both: --columns 'time=" +
                                 (is_finer ? name + "+" + further : further + "+" + name) + "'");
    }
    if (other.rows < kFewValues || !own.is_rising || !other.is_rising) continue;
    const double ratio = other.length_s() / own.length_s();
    if (std::fabs(ratio - 1) <= kNoticeable) continue;
    throw InputError(path, "two columns of times that run otherwise, '" +
                               printable(header.names[time]) + "' and '" +
                               printable(header.names[i]) +
                               "': if these are two tables, put each into a file and give --join; "
                               "if one holds for all columns, --columns 'time=" +
                               column_choice(header.names, time) +
                               "' or 'time=" + column_choice(header.names, i) + "'");
  }
}

void understand_times(const std::vector<std::string_view>& lines, const std::string& path,
                      CsvLayout& layout) {
  TimeColumn(lines, path, layout).understand();
}

}  // namespace fogcomp::recording
