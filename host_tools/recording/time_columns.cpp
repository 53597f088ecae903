#include "recording/column_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "recording/columns.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::string_view value_of(std::size_t field, const std::vector<std::string>& row) {
  return field < row.size() ? std::string_view(row[field]) : "";
}

bool may_be_of_calendar(const ColumnName& column, std::string_view value) {
  if (!parse_number(value)) return true;
  constexpr std::size_t kShortest = 6;
  const auto meaning = column.meaning();
  return meaning && meaning->slot == kTimeSlot &&
         std::min(value.find('.'), value.size()) >= kShortest;
}

constexpr std::size_t kYear = 0;
constexpr std::size_t kHour = 3;
constexpr std::size_t kMinute = 4;
constexpr std::size_t kEndOfParts = 6;

using PartsOfTime = std::array<std::size_t, kEndOfParts>;

// Columns that are called year, month, day, hour, minute and second, by themselves or all behind
// `before`; the number of columns where there is none.
PartsOfTime parts_of_time(const std::vector<ColumnName>& columns, std::string_view before) {
  constexpr std::array<std::string_view, kEndOfParts> kNames{
      "year yyyy", "month mon", "day dd", "h hh hr hour", "m mm min minute", "s ss sec second"};
  PartsOfTime parts;
  parts.fill(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::string name = columns[i].key;
    if (name.substr(0, before.size()) != before) continue;
    name.erase(0, before.size());
    if (!name.empty() && !before.empty() && (name[0] == '_' || name[0] == '.')) name.erase(0, 1);
    if (name.size() > 2 && name.back() == 's') name.pop_back();
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const std::vector<std::string> names = split(kNames[part], ' ');
      if (std::find(names.begin(), names.end(), name) != names.end()) parts[part] = i;
    }
  }
  return parts;
}

void name_letters(std::vector<ColumnName>& columns) {
  for (const std::string_view before : {"", "time"}) {
    const PartsOfTime parts = parts_of_time(columns, before);
    const auto missing = std::count(parts.begin() + kHour, parts.end(), columns.size());
    if (parts[kMinute] == columns.size() || missing > (before.empty() ? 1 : 0)) continue;
    constexpr std::string_view kUnits[] = {"h", "min", "s"};
    for (std::size_t i = kHour; i < kEndOfParts; ++i) {
      if (parts[i] == columns.size()) continue;
      columns[parts[i]].unit = find_unit(kUnits[i - kHour]);
      columns[parts[i]].unit_alone = true;
    }
  }
}

}  // namespace

std::vector<ColumnName> column_names(const std::vector<std::string>& names,
                                     const std::vector<std::string>& units) {
  std::vector<ColumnName> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns.emplace_back(names[i], i < units.size() ? units[i] : "");
  }
  name_letters(columns);
  return columns;
}

std::vector<std::size_t> columns_with(CalendarPart part, const std::vector<ColumnName>& columns,
                                      const std::vector<std::size_t>& free,
                                      const std::vector<std::string>& first_row) {
  std::vector<std::size_t> found;
  std::copy_if(free.begin(), free.end(), std::back_inserter(found), [&](std::size_t i) {
    const std::string_view value = value_of(i, first_row);
    return may_be_of_calendar(columns[i], value) && calendar_part(value) == part;
  });
  return found;
}

std::vector<std::size_t> calendar_in_parts(const std::vector<ColumnName>& columns) {
  for (const std::string_view before : {"", "time", "utc", "date", "local"}) {
    const PartsOfTime parts = parts_of_time(columns, before);
    const auto* const end = std::find(parts.begin(), parts.end(), columns.size());
    if (end >= parts.begin() + kEndOfParts - 1) return {parts.begin() + kYear, end};
  }
  return {};
}

std::optional<ChosenField> time_in_parts(const std::vector<ColumnName>& columns,
                                         const std::vector<std::size_t>& times,
                                         const std::vector<std::string>& first_row) {
  std::vector<std::size_t> sum = times;
  const auto unit_s = [&](std::size_t i) {  // a date comes first
    const std::string_view value = value_of(i, first_row);
    if (!parse_number(value) && calendar_part(value) == CalendarPart::date) return HUGE_VAL;
    const std::optional<Unit>& unit = columns[i].unit;
    return unit && unit->quantity == Quantity::time ? unit->convert(1) : 0;
  };
  std::sort(sum.begin(), sum.end(), [&](auto a, auto b) { return unit_s(a) > unit_s(b); });
  const std::size_t of_date = !sum.empty() && std::isinf(unit_s(sum[0])) ? 1 : 0;
  if (sum.size() < 2 + of_date || sum.size() > kMaxTimeParts + of_date) return std::nullopt;
  ChosenField chosen{sum[0]};
  for (std::size_t i = 1; i < sum.size(); ++i) {
    const ColumnName& one = columns[sum[of_date]];
    const ColumnName& finer = columns[sum[i]];
    const bool are_alike =
        one.unit_alone == finer.unit_alone && (one.unit_alone || one.stem_key == finer.stem_key);
    if (!are_alike || unit_s(sum[i]) == unit_s(sum[i - 1]) || unit_s(sum[i]) == 0) {
      return std::nullopt;
    }
    chosen.parts.push_back({sum[i]});
  }
  return chosen;
}

}  // namespace fogcomp::recording
