#include "recording/csv_header.hpp"

#include <algorithm>

#include "recording/column_map.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {

bool CsvHeader::has(std::size_t slot) const {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

bool CsvHeader::is_constant(std::size_t slot) const {
  return std::any_of(constants.begin(), constants.end(),
                     [&](const Constant& each) { return each.slot == slot; });
}

bool CsvHeader::takes_row_of(const std::vector<std::string_view>& fields) const {
  return fields.size() == slots.size() + empty_behind &&
         std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(slots.size()), fields.end(),
                     [](std::string_view field) { return field.empty(); });
}

std::size_t CsvHeader::field_of(std::size_t slot) const {
  return static_cast<std::size_t>(std::find(slots.begin(), slots.end(), slot) - slots.begin());
}

std::string_view CsvHeader::time_of(const std::vector<std::string_view>& fields,
                                    std::string& both) const {
  if (calendar.empty()) return fields[field_of(kTimeSlot)];
  const std::string_view marks = calendar.size() <= 2 ? " " : "-- ::";
  both.clear();
  for (std::size_t i = 0; i < calendar.size(); ++i) {
    if (fields[calendar[i]].empty()) return {};
    if (i > 0) both += marks[i - 1];
    both += fields[calendar[i]];
  }
  if (calendar.size() == 1) both += " 0:00";
  return both;
}

Unit CsvHeader::unit_of(std::size_t slot) const {
  const auto found = std::find_if(conversions.begin(), conversions.end(),
                                  [&](const auto& each) { return each.slot == slot; });
  if (found != conversions.end()) return found->unit;
  return *find_unit(quantity_of(slot) == Quantity::rate ? "deg/h" : "s");
}

std::string printable(std::string_view field) {
  constexpr std::size_t kLongest = 40;
  return displayable(field.substr(0, kLongest)) + (field.size() > kLongest ? "..." : "");
}

}  // namespace fogcomp::recording
