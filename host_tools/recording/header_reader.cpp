#include "recording/csv_header.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "recording/column_map.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::size_t kRequiredSlots[] = {kTimeSlot, kTemperatureSlot, kRateSlot};
constexpr std::string_view kCountsName = "counts";
constexpr std::string_view kSamples = "samples";
constexpr std::string_view kSegmentName = "segment";
constexpr std::size_t kMaxNamesShown = 12;

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == kMaxNamesShown) return list + ", ...";
    list += (i == 0 ? "" : ", ") + (names[i].empty() ? "(no name)" : printable(names[i]));
  }
  return list;
}

std::vector<std::string> known_names() {
  std::vector<std::string> names{std::string(kCountsName), std::string(kSegmentName)};
  for (const ColumnInfo& info : kColumns) names.emplace_back(info.name);
  return names;
}

std::size_t slot_named(std::string_view name) {
  if (name == kSegmentName) return CsvHeader::kSegmentLabel;
  for (std::size_t slot = 0; slot < kColumns.size(); ++slot) {
    if (kColumns[slot].name == name) return slot;
  }
  return CsvHeader::kIgnored;
}

// Further columns are recognised only by a recording's own names: comparing all would take seconds.
std::vector<std::string> close_names(std::vector<std::string> names) {
  for (std::size_t i = rules::kMaxColumnsUnderstood; i < names.size(); ++i) {
    if (slot_named(without_quotes(names[i])) == CsvHeader::kIgnored) names[i].clear();
  }
  return names;
}

std::string quoted(const ColumnName& column) {
  return "'" + printable(column.text) + "'";
}

/// Determines the meaning of each field of one header.
class HeaderReader {
 public:
  HeaderReader(const HeaderLines& lines, const ReadOptions& options)
      : lines_(lines), options_(options) {
    std::vector<std::string> units;
    for (std::size_t i = 0; i < lines.names.size(); ++i) {
      units.push_back(unit_beside(lines, i));
      header_.names.push_back(without_quotes(lines.names[i]));
    }
    columns_ = column_names(close_names(lines.names), units);
    header_.slots.assign(header_.names.size(), CsvHeader::kIgnored);
  }

  CsvHeader read() {
    take_chosen();
    take_own_names();
    take_counts();
    for (std::size_t slot = 0; slot < kColumns.size(); ++slot) {
      if (!is_known(slot) && is_read(slot)) take_likely(slot);
    }
    for (const std::size_t slot : kRequiredSlots) {
      if (!take_given(slot)) require(slot);
    }
    name_ignored_columns();
    if (is_known(kInputRateSlot) && options_.default_input_rate_dph != 0) {
      say("its input_rate_dph is used; --latitude has no effect");
    }
    return std::move(header_);
  }

 private:
  using Fields = std::vector<std::size_t>;

  // In the row of units or, of all rows, in a column behind it that is called "unit".
  static std::string unit_beside(const HeaderLines& lines, std::size_t field) {
    if (field < lines.units.size()) return lines.units[field];
    if (field + 1 >= std::min(lines.names.size(), lines.first_row.size())) return "";
    const bool is_unit = ColumnName(lines.names[field + 1]).has_word({"unit", "einheit"});
    return is_unit ? lines.first_row[field + 1] : "";
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(lines_.where, what); }
  void say(const std::string& what) const { options_.watch.say(lines_.file, what); }

  bool is_known(std::size_t slot) const { return header_.has(slot) || header_.is_constant(slot); }

  // A table has no times.
  bool is_read(std::size_t slot) const {
    return !options_.is_table || (slot != kTimeSlot && slot != slot_of(Column::uptime_s));
  }

  std::string place(std::size_t field) const {
    return "column " + std::to_string(field + 1) + " " + quoted(columns_[field]);
  }

  /// Applies --columns or, if the file has all of its names, the columns that the model remembers.
  void take_chosen() {
    if (!options_.columns.empty()) {
      for (const ColumnChoice& choice : parse_column_map(options_.columns)) take_choice(choice);
      return;
    }
    std::vector<std::pair<ColumnChoice, ChosenField>> remembered;
    for (const ColumnChoice& choice : parse_column_map(options_.model_columns)) {
      const auto chosen = find_field(choice, columns_);
      if (!chosen && constant_of(choice)) continue;  // of one file
      if (!chosen) return;
      remembered.emplace_back(choice, *chosen);
    }
    for (const auto& [choice, chosen] : remembered) take(chosen, choice.slot);
  }

  void take_choice(const ColumnChoice& choice) {
    if (!is_read(choice.slot)) {
      fail("the lines of a --table have no times; leave " + map_key(choice.slot) +
           "= out of --columns");
    }
    const auto chosen = find_field(choice, columns_);
    const auto constant = constant_of(choice);
    if (!chosen && !constant) {
      fail("no column '" + printable(choice.name) + "', which --columns names; the header has " +
           joined(header_.names));
    }
    if (!chosen) return take_constant(choice.slot, *constant, choice.name);
    const std::string name = column_choice(header_.names, chosen->field);
    const bool has_name = name != std::to_string(chosen->field + 1);
    if (constant && has_name && !may_be(columns_[chosen->field], choice.slot)) {
      const std::string key = map_key(choice.slot);
      fail(key + "=" + printable(choice.name) + " can be " + place(chosen->field) +
           " or that value; give " + key + "=" + name + "[UNIT], or the value with a point: " +
           key + "=" + std::to_string(chosen->field + 1) + ".0[UNIT]");
    }
    take(*chosen, choice.slot);
  }

  // Whether the name of a column does not say that it is another one.
  static bool may_be(const ColumnName& column, std::size_t slot) {
    const auto meaning = column.meaning();
    if (meaning) return meaning->slot == slot;
    return !column.unit || column.unit->quantity == quantity_of(slot);
  }

  void take_constant(std::size_t slot, double value, const std::string& words) {
    const ColumnInfo& info = kColumns[slot];
    if (!info.can_be(value)) {
      fail(map_key(slot) + format(" is %.6g, outside %g to %g", value, info.min, info.max));
    }
    header_.constants.push_back({slot, value});
    header_.understood.push_back(map_key(slot) + ": " + printable(words) + ", as given");
  }

  /// Takes a recording's own names, in small letters or capitals.
  void take_own_names() {
    const auto take_names = [&](auto name_of) {
      std::vector<std::size_t> found(kColumns.size(), header_.names.size());
      for (std::size_t i = 0; i < header_.names.size(); ++i) {
        const std::size_t slot = slot_named(name_of(i));
        if (slot == CsvHeader::kSegmentLabel && !header_.has(slot)) header_.slots[i] = slot;
        if (slot >= kColumns.size() || header_.slots[i] != CsvHeader::kIgnored) continue;
        if (!is_read(slot) || (slot == kTimeSlot && columns_[i].unit_alone)) continue;
        if (found[slot] == header_.names.size() && is_known(slot)) continue;
        if (found[slot] < header_.names.size()) {
          const auto with_unit = [&](std::size_t field) {
            const std::optional<Unit>& unit = columns_[field].unit;
            return numbered(slot, field, unit ? "[" + unit->words + "]" : "");
          };
          fail("column '" + printable(header_.names[i]) + "' stands twice, in fields " +
               std::to_string(found[slot] + 1) + " and " + std::to_string(i + 1) +
               "; say which: --columns " + with_unit(found[slot]) + " or " + with_unit(i));
        }
        found[slot] = i;
        take(i, slot, std::nullopt);
      }
    };
    take_names([&](std::size_t i) { return header_.names[i]; });
    take_names([&](std::size_t i) { return columns_[i].key; });
  }

  // "'rate=3[deg/h]'".
  static std::string numbered(std::size_t slot, std::size_t field, const std::string& unit) {
    return "'" + map_key(slot) + "=" + std::to_string(field + 1) + unit + "'";
  }

  /// Uses `counts` as rate if there is a scale factor, or no other rate.
  void take_counts() {
    const auto counts = std::find_if(columns_.begin(), columns_.end(), [](const ColumnName& each) {
      return each.key == kCountsName;
    });
    const bool has_counts = counts != columns_.end();
    if (chosen_rate_ || !has_counts || (header_.has(kRateSlot) && !options_.scale_factor)) return;
    std::replace(header_.slots.begin(), header_.slots.end(), kRateSlot, CsvHeader::kIgnored);
    drop_conversion(kRateSlot);
    const auto field = static_cast<std::size_t>(counts - columns_.begin());
    header_.slots[field] = kRateSlot;
    convert(kRateSlot, counts_unit("'counts'", *find_unit(kCountsName)));
  }

  Unit counts_unit(const std::string& name, Unit counts) {
    const auto scale_factor =
        options_.scale_factor ? options_.scale_factor : options_.model_scale_factor;
    if (!scale_factor) {
      fail(name +
           " without a scale factor; give --scale-factor (counts per deg/s) or a column "
           "'rate_dph'");
    }
    uses_scale_factor_ = true;
    counts.factor *= kDphPerDegreePerSecond / *scale_factor;
    return counts;
  }

  /// Takes the only column whose name fits. If several fit, the user has to choose.
  void take_likely(std::size_t slot) {
    if (slot == kTimeSlot && (take_calendar() || take_date_and_clock())) return;
    Fields fields = likely(slot);
    if (slot == kTimeSlot) {
      if (const auto sum = time_in_parts(columns_, fields, lines_.first_row)) return take_sum(*sum);
      fields = exactly_named_or_all(fields);
    }
    if (fields.empty()) return;
    const bool required = slot == kTimeSlot || slot == kTemperatureSlot || slot == kRateSlot;
    if (fields.size() == 1) return take(fields.front(), slot, std::nullopt);
    if (required) fail_for_several(slot, fields);
  }

  /// A column that is called "time" comes before "loop_time_us".
  Fields exactly_named_or_all(const Fields& fields) const {
    const auto is_exact = [&](std::size_t field) { return columns_[field].stem_key == "time"; };
    if (std::count_if(fields.begin(), fields.end(), is_exact) != 1) return fields;
    return {*std::find_if(fields.begin(), fields.end(), is_exact)};
  }

  void take_sum(const ChosenField& chosen) {
    if (!chosen.parts.empty() && is_date(chosen.field)) header_.calendar = {chosen.field};
    take(chosen.field, kTimeSlot, chosen.unit);
    for (std::size_t i = 0; i < chosen.parts.size(); ++i) {
      take_time_part(chosen.parts[i], CsvHeader::kTimePart + i);
    }
  }

  void take_time_part(const ChosenField& part, std::size_t slot) {
    const std::optional<Unit> unit = part.unit ? part.unit : columns_[part.field].unit;
    if (!unit || unit->quantity != Quantity::time) {
      fail(place(part.field) + " has no unit of time; give it: --columns 'time=NAME[s]+" +
           column_choice(header_.names, part.field) + "[ns]'");
    }
    header_.slots[part.field] = slot;
    convert(slot, *unit);
    header_.understood.push_back("to which is added " + place(part.field) +
                                 unit->conversion_words());
  }

  // Of the columns left over those that are so.
  template <class Is>
  Fields left_over(Is is) const {
    Fields fields;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (header_.slots[i] == CsvHeader::kIgnored && is(columns_[i])) fields.push_back(i);
    }
    return fields;
  }

  std::vector<std::string> names_of(const Fields& fields) const {
    std::vector<std::string> names;
    for (const std::size_t field : fields) names.push_back(header_.names[field]);
    return names;
  }

  Fields likely(std::size_t slot) const {
    return left_over([&](const ColumnName& column) {
      const auto meaning = column.meaning();
      return !column.key.empty() && meaning && meaning->slot == slot;
    });
  }

  [[noreturn]] void fail_for_several(std::size_t slot, const Fields& fields) const {
    std::vector<std::string> places;
    for (const std::size_t field : fields) {
      if (places.size() < kMaxNamesShown) places.push_back(place(field));
    }
    std::string what = map_key(slot) + " could be " + join(places, " or ") +
                       "; say which: --columns '" + map_key(slot) + "=" +
                       proposal(fields.front(), slot) + "'";
    if (slot == kRateSlot) {
      what += ", or --rate-column '" + proposal(fields.front(), slot) + "'";
    }
    fail(what);
  }

  // Of a file that has no such column at all.
  static std::string way_without(std::size_t slot) {
    if (slot == kTimeSlot) {
      return "; without times: --rate HZ (even samples) or --table (means at steady temperatures)";
    }
    return slot == kTemperatureSlot ? "; without temperatures: --temperature DEGC" : "";
  }

  // The column in the syntax of --columns.
  std::string proposal(std::size_t field, std::size_t slot) const {
    const ColumnName& column = columns_[field];
    const std::string name = column_choice(header_.names, field);
    const bool has_unit_in_name = column.unit && key_of_name(name) == column.key;
    if (column.unit) return has_unit_in_name ? name : name + "[" + column.unit->words + "]";
    return slot == kRateSlot ? name + unit_proposal(slot) : name;
  }

  void take(const ChosenField& chosen, std::size_t slot) {
    if (slot == kTimeSlot) header_.time_is_chosen = true;
    if (slot == kInputRateSlot) header_.input_rate_is_chosen = true;
    const std::vector<ChosenField>& parts = chosen.parts;
    if (parts.size() == 1 && is_date(chosen.field) && is_clock(parts[0].field)) {
      return take_date_and_clock(chosen.field, parts[0].field, chosen.unit);
    }
    if (!parts.empty()) return take_sum(chosen);
    take(chosen.field, slot, chosen.unit);
  }

  std::string_view first_value(std::size_t field) const {
    return field < lines_.first_row.size() ? std::string_view(lines_.first_row[field]) : "";
  }
  bool is_date(std::size_t field) const {
    return calendar_part(first_value(field)) == CalendarPart::date;
  }
  bool is_clock(std::size_t field) const {
    return calendar_part(first_value(field)) == CalendarPart::time_of_day;
  }

  void take_date_and_clock(std::size_t date, std::size_t clock, const std::optional<Unit>& order) {
    header_.calendar = {date, clock};
    header_.slots[date] = CsvHeader::kDate;
    header_.slots[clock] = kTimeSlot;
    take_order(order ? order : columns_[date].unit);
    header_.understood.push_back("time: " + place(date) + " and " + place(clock));
  }

  // Of day and month.
  void take_order(const std::optional<Unit>& unit) {
    if (!unit || unit->quantity != Quantity::date) return;
    header_.day_order = unit->words[0] == 'D' ? DayOrder::day_first : DayOrder::month_first;
  }

  /// Takes year, month, day, hour, minute and perhaps second.
  bool take_calendar() {
    const Fields parts = calendar_in_parts(columns_);
    const Fields times = likely(kTimeSlot);
    const bool is_only_time = std::all_of(times.begin(), times.end(), [&](std::size_t field) {
      return std::find(parts.begin(), parts.end(), field) != parts.end();
    });
    if (parts.empty() || !is_only_time) return false;
    header_.calendar = parts;
    for (const std::size_t field : header_.calendar) header_.slots[field] = CsvHeader::kDate;
    header_.slots[header_.calendar.back()] = kTimeSlot;
    header_.understood.push_back("time: " + place(header_.calendar.front()) + " to " +
                                 place(header_.calendar.back()));
    return true;
  }

  /// Takes the only column of dates and the only one of times of day.
  bool take_date_and_clock() {
    const Fields free = left_over([](const ColumnName&) { return true; });
    const Fields dates = columns_with(CalendarPart::date, columns_, free, lines_.first_row);
    const Fields clocks = columns_with(CalendarPart::time_of_day, columns_, free, lines_.first_row);
    if (dates.empty() || clocks.empty()) return false;
    if (dates.size() == 1 && clocks.size() == 1) {
      take_date_and_clock(dates[0], clocks[0], std::nullopt);
      return true;
    }
    const std::string sum =
        column_choice(header_.names, dates[0]) + "+" + column_choice(header_.names, clocks[0]);
    fail("time could be of several dates or times of day, such as " + place(dates[0]) + " and " +
         place(clocks[0]) + "; say which: --columns 'time=" + sum + "'");
  }

  void take(std::size_t field, std::size_t slot, const std::optional<Unit>& given) {
    const ColumnName& column = columns_[field];
    if (slot == kRateSlot && (given || !options_.columns.empty())) chosen_rate_ = true;
    header_.slots[field] = slot;
    if (slot >= kColumns.size()) return;
    if (!given && !column.contradiction.empty()) {
      fail(column.contradiction + "; correct one of them, or say which: --columns " +
           numbered(slot, field, unit_proposal(slot)));
    }
    if (!given && column.factor) fail_for_factor(field, slot);
    if (!given && quantity_of(slot) == Quantity::rate && column.has_minus()) {
      const std::string unit = (column.unit ? column.unit->words : "deg/s") + "]";
      fail(place(field) + " may have the other sign; say whether: --columns " +
           numbered(slot, field, "[-" + unit) + " changes it, " +
           numbered(slot, field, "[" + unit) + " does not");
    }
    if (given && column.unit && given->words != column.unit->words) {
      say(place(field) + " is taken in " + given->words + ", as chosen, not in " +
          column.unit->words);
    }
    use_unit(field, slot, given ? given : column.unit);
  }

  // The same number may be multiplied by it or wait to be.
  [[noreturn]] void fail_for_factor(std::size_t field, std::size_t slot) const {
    const ColumnName& column = columns_[field];
    const std::string unit = (column.unit ? column.unit->words : "UNIT") + "]";
    fail(place(field) + " has a factor, so that a 1 can mean several things; give it: --columns " +
         numbered(slot, field, format("[%.12g ", 1 / *column.factor) + unit) + ", " +
         numbered(slot, field, format("[%.12g ", *column.factor) + unit) + ", or " +
         numbered(slot, field, "[" + unit) + " if none is meant");
  }

  void use_unit(std::size_t field, std::size_t slot, std::optional<Unit> unit) {
    const ColumnName& column = columns_[field];
    if (slot == kTimeSlot &&
        (!header_.calendar.empty() || (unit && unit->quantity == Quantity::date))) {
      take_order(unit);
      unit.reset();
    }
    if (unit && unit->quantity == Quantity::counts && quantity_of(slot) == Quantity::rate) {
      unit = counts_unit(place(field), *unit);
    } else if (unit && unit->quantity != quantity_of(slot)) {
      fail(place(field) + " is in " + unit->words + ", which is no unit of " + map_key(slot) +
           "; if it is, give the right one: --columns " +
           numbered(slot, field, unit_proposal(slot)));
    }
    if (unit && unit->words == kSamples && slot == kTimeSlot) {
      if (!options_.stream_rate_hz) fail(place(field) + " counts samples; give --rate (Hz)");
      counts_samples_ = true;
      unit->divisor = *options_.stream_rate_hz;
    }
    if (!unit && !column.unknown_unit.empty()) {
      fail(place(field) + ": unit '" + printable(column.unknown_unit) +
           "' is not known; give it: --columns " + numbered(slot, field, "[UNIT]") + ", of " +
           join(units_of(quantity_of(slot)), ", ") + " or a multiple such as 0.1 " +
           units_of(quantity_of(slot)).front());
    }
    const bool own = column.key == kColumns[slot].name;
    if (!unit && slot == kRateSlot && !own) {
      fail(place(field) + " has no unit; give it: --columns 'rate=" + proposal(field, slot) + "'");
    }
    if (slot == kTimeSlot) header_.time_has_unit = unit.has_value() || own;
    if (unit) convert(slot, *unit);
    if (column.text == kColumns[slot].name && (!unit || unit->is_ours())) return;
    header_.understood.push_back(map_key(slot) + ": " + place(field) +
                                 (unit ? unit->conversion_words() : " as " + own_unit(slot)));
  }

  static std::string own_unit(std::size_t slot) {
    if (slot == kTimeSlot) return "s";
    return slot == kTemperatureSlot ? "degC" : "it is";
  }

  // A question where two units are as likely.
  static std::string unit_proposal(std::size_t slot) {
    if (slot == kTimeSlot) return "[s]";
    return quantity_of(slot) == Quantity::rate ? "[deg/s or rad/s?]" : "[degC]";
  }

  void convert(std::size_t slot, const Unit& unit) {
    drop_conversion(slot);
    if (!unit.is_ours()) header_.conversions.push_back({slot, unit});
  }

  void drop_conversion(std::size_t slot) {
    auto& all = header_.conversions;
    all.erase(
        std::remove_if(all.begin(), all.end(), [&](const auto& each) { return each.slot == slot; }),
        all.end());
  }

  /// Whether an option says what the file does not.
  bool take_given(std::size_t slot) {
    const bool has_column = is_known(slot);
    if (slot == kTemperatureSlot && options_.temperature_degc) {
      if (has_column) {
        say("its own temperatures are used; --temperature has no effect");
      } else {
        take_constant(slot, *options_.temperature_degc,
                      format("none, %g degC", *options_.temperature_degc));
      }
      return true;
    }
    if (slot == kTemperatureSlot && !options_.join.empty()) return true;
    if (slot == kRateSlot && options_.without_rate && !has_column) {
      header_.constants.push_back({slot, 0});
      return true;
    }
    if (slot == kTimeSlot && options_.is_table) {
      header_.understood.emplace_back("a table: each line is the mean of a steady temperature");
      return true;
    }
    if (slot == kTimeSlot && options_.stream_rate_hz) {
      if (!has_column) {
        header_.understood.push_back(
            format("time: none, a sample each %g s as given", 1 / *options_.stream_rate_hz));
      } else if (!counts_samples_) {
        say("a CSV has its own times; --rate only helps where they are those of arrival");
      }
      return true;
    }
    return false;
  }

  void require(std::size_t slot) const {
    if (is_known(slot)) return;
    const Fields fields = left_over([&](const ColumnName& column) {
      return column.unit && column.unit->quantity == quantity_of(slot);  // whatever the name
    });
    if (!fields.empty()) fail_for_several(slot, fields);
    const std::string name(kColumns[slot].name);
    const std::vector<std::string> free = names_of(left_over([](const ColumnName& column) {
      return !column.unit || column.unit->quantity == Quantity::other;  // the name may be wrong
    }));
    fail("no column '" + name + "'" + did_you_mean(name, free) + "; the header has " +
         joined(header_.names) + "; rename or add it, or say which it is: --columns " +
         map_key(slot) + "=NAME" + unit_proposal(slot) + way_without(slot));
  }

  void name_ignored_columns() const {
    if (options_.scale_factor && !uses_scale_factor_) {
      say("no column 'counts': --scale-factor has no effect");
    }
    const std::vector<std::string> ignored =
        names_of(left_over([](const ColumnName&) { return true; }));
    if (ignored.empty()) return;
    std::string hint;
    if (ignored.size() == 1 && slot_named(ignored[0]) == CsvHeader::kIgnored)
      hint = did_you_mean(ignored[0], known_names());
    say(std::string("column") + (ignored.size() == 1 ? "" : "s") + " ignored: " + joined(ignored) +
        hint);
  }

  const HeaderLines& lines_;
  const ReadOptions& options_;
  std::vector<ColumnName> columns_;
  CsvHeader header_;
  bool chosen_rate_ = false;
  bool uses_scale_factor_ = false;
  bool counts_samples_ = false;  // its times
};

}  // namespace

std::size_t required_columns_among(const std::vector<std::string>& names,
                                   const ReadOptions& options) {
  const std::vector<ColumnName> columns = column_names(close_names(names), {});
  std::set<std::size_t> found;
  for (const ColumnName& column : columns) {
    if (column.key.empty()) continue;
    if (column.key == kCountsName) found.insert(kRateSlot);
    if (const auto meaning = column.meaning()) found.insert(meaning->slot);
    found.insert(slot_named(column.key));
  }
  for (const std::string& map : {options.columns, options.model_columns}) {
    for (const ColumnChoice& choice : parse_column_map(map)) {
      if (find_field(choice, columns) || constant_of(choice)) found.insert(choice.slot);
    }
  }
  if (!calendar_in_parts(columns).empty()) found.insert(kTimeSlot);
  if (options.temperature_degc || !options.join.empty()) found.insert(kTemperatureSlot);
  if (options.without_rate) found.insert(kRateSlot);
  if (options.stream_rate_hz || options.is_table) found.insert(kTimeSlot);
  return static_cast<std::size_t>(
      std::count_if(std::begin(kRequiredSlots), std::end(kRequiredSlots),
                    [&](std::size_t slot) { return found.count(slot) > 0; }));
}

CsvHeader understand_header(const HeaderLines& lines, const ReadOptions& options) {
  return HeaderReader(lines, options).read();
}

}  // namespace fogcomp::recording
