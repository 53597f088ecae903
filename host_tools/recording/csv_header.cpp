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

std::string quoted(const ColumnName& column) {
  return "'" + printable(column.text) + "'";
}

/// Determines the meaning of each field of one header.
class HeaderReader {
 public:
  HeaderReader(const HeaderLines& lines, const ReadOptions& options)
      : lines_(lines), options_(options) {
    for (std::size_t i = 0; i < lines.names.size(); ++i) {
      // Further columns are recognised only by a recording's own names: comparing all would take
      // seconds.
      const bool close = i < rules::kMaxColumnsUnderstood ||
                         slot_named(without_quotes(lines.names[i])) != CsvHeader::kIgnored;
      columns_.emplace_back(close ? lines.names[i] : "",
                            close && i < lines.units.size() ? lines.units[i] : "");
      header_.names.push_back(without_quotes(lines.names[i]));
    }
    header_.slots.assign(header_.names.size(), CsvHeader::kIgnored);
  }

  CsvHeader read() {
    take_chosen();
    take_own_names();
    take_counts();
    for (std::size_t slot = 0; slot < kColumns.size(); ++slot) {
      if (!header_.has(slot)) take_likely(slot);
    }
    for (const std::size_t slot : kRequiredSlots) require(slot);
    name_ignored_columns();
    if (header_.has(kInputRateSlot) && options_.default_input_rate_dph != 0) {
      say("its input_rate_dph is used; --latitude has no effect");
    }
    return std::move(header_);
  }

 private:
  using Fields = std::vector<std::size_t>;

  [[noreturn]] void fail(const std::string& what) const { throw InputError(lines_.where, what); }
  void say(const std::string& what) const { options_.watch.say(lines_.file, what); }

  std::string place(std::size_t field) const {
    return "column " + std::to_string(field + 1) + " " + quoted(columns_[field]);
  }

  /// Applies --columns or, if the file has all of its names, the columns that the model remembers.
  void take_chosen() {
    if (!options_.columns.empty()) {
      for (const ColumnChoice& choice : parse_column_map(options_.columns)) {
        const auto chosen = find_field(choice, columns_);
        if (!chosen) {
          fail("no column '" + printable(choice.name) +
               "', which --columns names; the header has " + joined(header_.names));
        }
        take(chosen->field, choice.slot, chosen->unit);
      }
      return;
    }
    std::vector<std::pair<ColumnChoice, ChosenField>> remembered;
    for (const ColumnChoice& choice : parse_column_map(options_.model_columns)) {
      const auto chosen = find_field(choice, columns_);
      if (!chosen) return;
      remembered.emplace_back(choice, *chosen);
    }
    for (const auto& [choice, chosen] : remembered) take(chosen.field, choice.slot, chosen.unit);
  }

  /// Takes a recording's own names, in small letters or capitals.
  void take_own_names() {
    const auto take_names = [&](auto name_of) {
      std::vector<std::size_t> found(kColumns.size(), header_.names.size());
      for (std::size_t i = 0; i < header_.names.size(); ++i) {
        const std::size_t slot = slot_named(name_of(i));
        if (slot == CsvHeader::kSegmentLabel && !header_.has(slot)) header_.slots[i] = slot;
        if (slot >= kColumns.size() || header_.slots[i] != CsvHeader::kIgnored) continue;
        if (found[slot] == header_.names.size() && header_.has(slot)) continue;
        if (found[slot] < header_.names.size()) {
          fail("column '" + printable(header_.names[i]) + "' stands twice, in fields " +
               std::to_string(found[slot] + 1) + " and " + std::to_string(i + 1) +
               "; rename or remove one");
        }
        found[slot] = i;
        take(i, slot, std::nullopt);
      }
    };
    take_names([&](std::size_t i) { return header_.names[i]; });
    take_names([&](std::size_t i) { return columns_[i].key; });
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
    convert(kRateSlot, counts_unit("'counts'"));
  }

  Unit counts_unit(const std::string& name) {
    const auto scale_factor =
        options_.scale_factor ? options_.scale_factor : options_.model_scale_factor;
    if (!scale_factor) {
      fail(name +
           " without a scale factor; give --scale-factor (counts per deg/s) or a column "
           "'rate_dph'");
    }
    uses_scale_factor_ = true;
    return {Quantity::rate, "counts", kDphPerDegreePerSecond / *scale_factor};
  }

  /// Takes the only column whose name fits. If several fit, the user has to choose.
  void take_likely(std::size_t slot) {
    Fields fields = likely(slot);
    if (slot == kTimeSlot && fields.size() > 1) {
      const Fields all = fields;
      fields.erase(std::remove_if(fields.begin(), fields.end(),
                                  [&](std::size_t field) { return !columns_[field].unit; }),
                   fields.end());
      if (fields.empty()) fields = all;
    }
    if (fields.empty()) return;
    const bool required = slot == kTimeSlot || slot == kTemperatureSlot || slot == kRateSlot;
    if (fields.size() == 1) return take(fields.front(), slot, std::nullopt);
    if (required) fail_for_several(slot, fields);
  }

  Fields likely(std::size_t slot) const {
    Fields fields;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (header_.slots[i] != CsvHeader::kIgnored || columns_[i].key.empty()) continue;
      const auto meaning = columns_[i].meaning();
      if (meaning && meaning->slot == slot) fields.push_back(i);
    }
    return fields;
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

  // The column in the syntax of --columns.
  std::string proposal(std::size_t field, std::size_t slot) const {
    const ColumnName& column = columns_[field];
    const bool number = column.text.find(',') != std::string::npos || column.text.empty();
    const std::string name = number ? std::to_string(field + 1) : displayable(column.text);
    if (column.unit) return number ? name + "[" + column.unit->words + "]" : name;
    return name + (slot == kRateSlot ? "[deg/s]" : slot == kTimeSlot ? "[s]" : "[degC]");
  }

  void take(std::size_t field, std::size_t slot, const std::optional<Unit>& given) {
    const ColumnName& column = columns_[field];
    if (slot == kRateSlot && (given || !options_.columns.empty())) chosen_rate_ = true;
    header_.slots[field] = slot;
    if (slot >= kColumns.size()) return;
    if (!column.contradiction.empty()) fail(column.contradiction + "; correct one of them");
    if (given && column.unit && given->words != column.unit->words) {
      fail(place(field) + " is in " + column.unit->words + ", --columns says " + given->words +
           "; correct one of them");
    }
    use_unit(field, slot, given ? given : column.unit);
  }

  void use_unit(std::size_t field, std::size_t slot, std::optional<Unit> unit) {
    const ColumnName& column = columns_[field];
    if (unit && unit->quantity == Quantity::counts && quantity_of(slot) == Quantity::rate) {
      unit = counts_unit(place(field));
    }
    if (unit && unit->quantity != quantity_of(slot)) {
      fail(place(field) + " is in " + unit->words + ", which is no unit of " + map_key(slot));
    }
    if (!unit && !column.unknown_unit.empty()) {
      fail(place(field) + ": unit '" + printable(column.unknown_unit) +
           "' is not known; give it: --columns '" + map_key(slot) + "=" +
           std::to_string(field + 1) + unit_proposal(slot) + "'");
    }
    const bool own = column.key == kColumns[slot].name;
    if (!unit && slot == kRateSlot && !own) {
      fail(place(field) + " has no unit; give it: --columns 'rate=" + proposal(field, slot) +
           "' (or deg/h, rad/s, ...)");
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

  static std::string unit_proposal(std::size_t slot) {
    if (slot == kTimeSlot) return "[s]";
    return quantity_of(slot) == Quantity::rate ? "[deg/s]" : "[degC]";
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

  // Columns left over whose unit is one of the slot's quantity, whatever their names.
  Fields of_its_unit(std::size_t slot) const {
    Fields fields;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::optional<Unit>& unit = columns_[i].unit;
      if (header_.slots[i] != CsvHeader::kIgnored || !unit) continue;
      if (unit->quantity == quantity_of(slot)) fields.push_back(i);
    }
    return fields;
  }

  void require(std::size_t slot) const {
    if (header_.has(slot)) return;
    const Fields fields = of_its_unit(slot);
    if (!fields.empty()) fail_for_several(slot, fields);
    const std::string name(kColumns[slot].name);
    std::vector<std::string> free;  // fields whose only fault may be the name
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const bool other_unit = columns_[i].unit && columns_[i].unit->quantity != Quantity::other;
      if (header_.slots[i] == CsvHeader::kIgnored && !other_unit) free.push_back(header_.names[i]);
    }
    fail("no column '" + name + "'" + did_you_mean(name, free) + "; the header has " +
         joined(header_.names) + "; rename or add it, or say which it is: --columns " +
         map_key(slot) + "=NAME" + unit_proposal(slot));
  }

  void name_ignored_columns() const {
    if (options_.scale_factor && !uses_scale_factor_) {
      say("no column 'counts': --scale-factor has no effect");
    }
    std::vector<std::string> ignored;
    for (std::size_t i = 0; i < header_.names.size(); ++i) {
      if (header_.slots[i] == CsvHeader::kIgnored) ignored.push_back(header_.names[i]);
    }
    if (ignored.empty()) return;
    std::string hint;
    if (ignored.size() == 1) hint = did_you_mean(ignored[0], known_names());
    say(std::string("column") + (ignored.size() == 1 ? "" : "s") + " ignored: " + joined(ignored) +
        hint);
  }

  const HeaderLines& lines_;
  const ReadOptions& options_;
  std::vector<ColumnName> columns_;
  CsvHeader header_;
  bool chosen_rate_ = false;
  bool uses_scale_factor_ = false;
};

}  // namespace

std::string printable(std::string_view field) {
  constexpr std::size_t kLongest = 40;
  return displayable(field.substr(0, kLongest)) + (field.size() > kLongest ? "..." : "");
}

bool CsvHeader::has(std::size_t slot) const {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

std::size_t CsvHeader::field_of(std::size_t slot) const {
  return static_cast<std::size_t>(std::find(slots.begin(), slots.end(), slot) - slots.begin());
}

std::size_t required_columns_among(const std::vector<std::string>& names,
                                   const ReadOptions& options) {
  std::vector<ColumnName> columns;
  for (const std::string& name : names) {
    const bool close = columns.size() < rules::kMaxColumnsUnderstood ||
                       slot_named(without_quotes(name)) != CsvHeader::kIgnored;
    columns.emplace_back(close ? name : "");
  }
  std::set<std::size_t> found;
  for (const ColumnName& column : columns) {
    if (column.key.empty()) continue;
    if (column.key == kCountsName) found.insert(kRateSlot);
    if (const auto meaning = column.meaning()) found.insert(meaning->slot);
    found.insert(slot_named(column.key));
  }
  for (const std::string& map : {options.columns, options.model_columns}) {
    for (const ColumnChoice& choice : parse_column_map(map)) {
      if (find_field(choice, columns)) found.insert(choice.slot);
    }
  }
  return static_cast<std::size_t>(
      std::count_if(std::begin(kRequiredSlots), std::end(kRequiredSlots),
                    [&](std::size_t slot) { return found.count(slot) > 0; }));
}

CsvHeader understand_header(const HeaderLines& lines, const ReadOptions& options) {
  return HeaderReader(lines, options).read();
}

}  // namespace fogcomp::recording
