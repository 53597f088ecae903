#include "recording/column_map.hpp"

#include <algorithm>

#include "recording/columns.hpp"
#include "recording/csv_header.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr const char* kOption = "--columns";

std::vector<std::string> map_keys() {
  std::vector<std::string> keys;
  for (std::size_t slot = 0; slot < kColumns.size(); ++slot) keys.push_back(map_key(slot));
  return keys;
}

std::size_t slot_of_key(const std::string& key) {
  for (std::size_t slot = 0; slot < kColumns.size(); ++slot) {
    if (key == map_key(slot) || key == kColumns[slot].name) return slot;
  }
  if (key == "segment") return CsvHeader::kSegmentLabel;
  throw InputError(kOption, "a recording has no '" + printable(key) + "'" +
                                did_you_mean(key, map_keys()) + "; it has " +
                                join(map_keys(), ", "));
}

// Finds the name with this `key`; several cannot be told apart.
template <class Key>
std::optional<std::size_t> only_one(const std::vector<ColumnName>& names, const std::string& wanted,
                                    Key key) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].*key != wanted) continue;
    if (found) {
      throw InputError(kOption, "columns " + std::to_string(*found + 1) + " and " +
                                    std::to_string(i + 1) + " are both '" + printable(wanted) +
                                    "'; give the number of the one that is meant");
    }
    found = i;
  }
  return found;
}

std::optional<std::size_t> field_named(const std::string& name,
                                       const std::vector<ColumnName>& names) {
  const std::string key = key_of_name(name);
  if (key.empty()) return std::nullopt;
  if (const auto whole = only_one(names, key, &ColumnName::key)) return whole;
  if (const auto stem = only_one(names, key, &ColumnName::stem_key)) return stem;
  const auto number = parse_number(key);
  const bool is_field = number && *number >= 1 && *number <= static_cast<double>(names.size()) &&
                        key.find_first_not_of("0123456789") == std::string::npos;
  return is_field ? std::optional(static_cast<std::size_t>(*number) - 1) : std::nullopt;
}

// By a name with or without a unit.
std::optional<ChosenField> find_one(const std::string& name, const std::vector<ColumnName>& names) {
  if (const auto whole = field_named(name, names)) return ChosenField{*whole};
  const ColumnName apart(name);
  const std::size_t bracket = name.find_last_of("[(");
  if (bracket == std::string::npos || name.find_last_of("])") + 1 != name.size()) {
    return std::nullopt;
  }
  const auto field = field_named(name.substr(0, bracket), names);
  if (!field) return std::nullopt;
  if (!apart.unit) {
    throw InputError(kOption, "'" + printable(name) + "' has no unit that is known (" +
                                  printable(apart.unknown_unit) + ")");
  }
  return ChosenField{*field, apart.unit};
}

}  // namespace

std::optional<double> constant_of(const ColumnChoice& choice) {
  const ColumnName apart(choice.name);
  const auto number = parse_number(apart.stem_key);
  const bool may_be =
      choice.slot < kColumns.size() && choice.slot != kTimeSlot && choice.slot != kRateSlot;
  if (!may_be || !number || !apart.unit || apart.unit->quantity != quantity_of(choice.slot)) {
    return std::nullopt;
  }
  return apart.unit->convert(*number);
}

// --columns parts names at commas, and a shell its words at apostrophes.
std::string column_choice(const std::vector<std::string>& names, std::size_t field) {
  const std::string& name = names[field];
  const bool is_alone = std::count(names.begin(), names.end(), name) == 1;
  const bool is_plain =
      name.find_first_of(",'\"\n") == std::string::npos && displayable(name) == name;
  return !name.empty() && is_alone && is_plain ? name : std::to_string(field + 1);
}

std::string map_key(std::size_t slot) {
  const std::string_view name = kColumns[slot].name;
  return std::string(name.substr(0, name.rfind('_')));
}

std::vector<ColumnChoice> parse_column_map(const std::string& text) {
  std::vector<ColumnChoice> choices;
  for (const std::string& part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || trim(part.substr(equals + 1)).empty()) {
      throw InputError(
          kOption,
          "'" + printable(part) + "' is no COLUMN=NAME[UNIT]; give time=Time[ms],rate=Gyro[deg/s]");
    }
    ColumnChoice choice{slot_of_key(folded(part.substr(0, equals))),
                        std::string(trim(part.substr(equals + 1)))};
    for (const ColumnChoice& other : choices) {
      if (other.slot != choice.slot) continue;
      throw InputError(
          kOption, "two columns are given for " + folded(part.substr(0, equals)) + "; give one");
    }
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::optional<ChosenField> find_field(const ColumnChoice& choice,
                                      const std::vector<ColumnName>& names) {
  if (const auto one = find_one(choice.name, names)) return one;
  if (choice.slot != kTimeSlot) return std::nullopt;
  std::optional<ChosenField> sum;
  for (const std::string& name : split(choice.name, '+')) {
    const auto part = find_one(name, names);
    if (!part || (sum && sum->parts.size() == kMaxTimeParts)) return std::nullopt;
    if (sum) sum->parts.push_back(*part);
    if (!sum) sum = part;
  }
  return sum;
}

}  // namespace fogcomp::recording
