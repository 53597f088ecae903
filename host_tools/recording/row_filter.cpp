#include "recording/row_filter.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "recording/column_map.hpp"
#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/csv_layout.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr const char* kWhere = "--where";

// Number of rows, mean and sum of squares about it.
struct Level {
  double count = 0;
  double mean = 0;
  double square = 0;
  void add(double value) {
    const double from_mean = value - mean;
    mean += from_mean / ++count;
    square += from_mean * (value - mean);
  }
};

// The values of one column, in the first rows.
struct Sensors {
  struct Sensor {
    double rows = 0;
    Level rate;
    Level temperature;
  };
  std::map<std::string, Sensor> sensors;
  std::string last;
  double rows = 0;
  double changes = 0;

  using Number = std::optional<double>;
  void add(const std::string& value, const Number& rate, const Number& temperature) {
    if (rows > 0 && value != last) ++changes;
    last = value;
    ++rows;
    Sensor& sensor = sensors[value];
    ++sensor.rows;
    if (rate) sensor.rate.add(*rate);
    if (temperature) sensor.temperature.add(*temperature);
  }

  bool take_turns() const {
    const auto count = static_cast<double>(sensors.size());
    if (count < 2 || sensors.size() > rules::kMaxSensors || 2 * changes < rows) return false;
    return std::all_of(sensors.begin(), sensors.end(), [&](const auto& each) {
      return 2 * count * each.second.rows > rows && count * each.second.rows < 2 * rows;
    });
  }

  // Whether the means of some two differ by more than their scatter.
  bool differ(Level Sensor::*of) const {
    for (const auto& one : sensors) {
      for (const auto& other : sensors) {
        const Level& a = one.second.*of;
        const Level& b = other.second.*of;
        if (a.count < 2 || b.count < 2) continue;
        const double variance =
            a.square / (a.count - 1) / a.count + b.square / (b.count - 1) / b.count;
        const double apart = a.mean - b.mean;
        if (apart * apart > kCertainSigmas * kCertainSigmas * variance) return true;
      }
    }
    return false;
  }
};

bool names_sensors(const std::string& text) {
  const ColumnName name(text);
  return name.key == "i" || name.key == "id" ||
         name.has_word({"sensor", "imu", "instance", "device", "unit", "node", "channel"});
}

// What the columns that are not understood say of the first rows.
std::vector<Sensors> unknown_columns(const std::vector<std::string_view>& lines,
                                     const CsvLayout& layout) {
  const CsvHeader& header = layout.header;
  std::vector<Sensors> columns(std::min(header.slots.size(), rules::kMaxColumnsUnderstood));
  for_each_row(lines, layout, [&](std::size_t, const std::vector<std::string_view>& fields) {
    const auto number_of = [&](std::size_t slot) {
      const std::size_t field = header.field_of(slot);
      double value = 0;
      const bool is_number = field < std::min(fields.size(), header.slots.size()) &&
                             read_number(fields[field], layout.dialect, value) == FieldKind::number;
      return is_number ? std::optional(value) : std::nullopt;
    };
    const auto rate = number_of(kRateSlot);
    const auto temperature = number_of(kTemperatureSlot);
    for (std::size_t field = 0; field < std::min(columns.size(), fields.size()); ++field) {
      const bool is_unknown = header.slots[field] == CsvHeader::kIgnored;
      if (!is_unknown || columns[field].sensors.size() > rules::kMaxSensors) continue;
      columns[field].add(std::string(fields[field]), rate, temperature);
    }
  });
  return columns;
}

}  // namespace

RowChoice parse_row_choice(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t equals = text.rfind('=');
  const RowChoice choice{
      std::string(trim(text.substr(0, equals))),
      equals == std::string::npos ? "" : std::string(trim(text.substr(equals + 1)))};
  if (choice.column.empty() || choice.value.empty()) {
    throw InputError(kWhere, "'" + printable(text) + "' is no COLUMN=VALUE; give SensorId=1");
  }
  return choice;
}

RowFilter::RowFilter(const CsvLayout& layout, const ReadOptions& options, const std::string& path)
    : separator_(layout.dialect.separator) {
  const RowChoice choice = parse_row_choice(options.where);
  if (choice.column.empty()) return;
  std::vector<ColumnName> columns;
  for (const std::string& name : layout.header.names) columns.emplace_back(name);
  const auto found = find_field({CsvHeader::kIgnored, choice.column}, columns);
  if (!found) {
    throw InputError(path, "no column '" + printable(choice.column) + "', which --where names" +
                               did_you_mean(choice.column, layout.header.names));
  }
  field_ = found->field;
  value_ = choice.value;
}

bool RowFilter::takes(std::string_view line) {
  split_fields(line, separator_, fields_);
  if (field_ >= fields_.size()) return true;  // a bad row
  const std::string_view field = fields_[field_];
  const auto number = parse_number(std::string(field));
  const bool is_taken = field == value_ || (number && number == parse_number(value_));
  if (!is_taken) ++left_out_;
  return is_taken;
}

RowMarks::RowMarks(const std::vector<std::string_view>& lines, const CsvLayout& layout)
    : layout_(layout),
      first_change_(layout.header.slots.size()),
      changes_(layout.header.slots.size()) {
  std::vector<std::string_view> before;
  for_each_row(lines, layout, [&](std::size_t line, const auto& fields) {
    if (fields.size() < first_change_.size()) return;
    if (first_row_.empty()) {
      first_row_.assign(fields.begin(), fields.end());
      before.assign(fields.begin(), fields.end());
    }
    for (std::size_t i = 0; i < first_change_.size(); ++i) {
      if (fields[i] == before[i]) continue;
      before[i] = fields[i];
      if (changes_[i]++ == 0) first_change_[i] = line + 1;
    }
  });
  const std::size_t close = std::min(first_change_.size(), rules::kMaxColumnsUnderstood);
  for (flag_ = 0; flag_ < close; ++flag_) {
    if (layout.header.slots[flag_] != CsvHeader::kIgnored) continue;
    const ColumnName name(layout.header.names[flag_]);
    if (name.has_word({"valid", "status", "quality", "flag", "healthy"})) return;
  }
  flag_ = first_change_.size();
}

std::string RowMarks::run_before(std::string_view line, std::size_t line_number) const {
  std::vector<std::string_view> fields;
  split_fields(line, layout_.dialect.separator, fields);
  for (std::size_t i = 0; i < std::min(fields.size(), first_row_.size()); ++i) {
    if (i >= first_change_.size() || layout_.header.slots[i] != CsvHeader::kIgnored) continue;
    if (first_change_[i] != 0 && first_change_[i] != line_number) continue;
    if (changes_[i] >= rules::kMaxSensors) continue;
    if (first_row_[i].empty() || fields[i] == first_row_[i]) continue;
    return "--where " + shell_word(column_choice(layout_.header.names, i) + "=" + first_row_[i]);
  }
  return "";
}

void RowMarks::see(std::string_view line) {
  std::vector<std::string_view> fields;
  split_fields(line, layout_.dialect.separator, fields);
  if (flag_ >= fields.size() || rows_of_flag_.size() > rules::kMaxSensors) return;
  ++rows_of_flag_[std::string(fields[flag_])];
}

std::string RowMarks::flag_words() const {
  if (rows_of_flag_.size() < 2 || rows_of_flag_.size() > rules::kMaxSensors) return "";
  std::vector<std::string> values;
  auto most = rows_of_flag_.begin();
  for (auto each = rows_of_flag_.begin(); each != rows_of_flag_.end(); ++each) {
    values.push_back("'" + printable(each->first) + "' in " + counted(each->second, "row"));
    if (each->second > most->second) most = each;
  }
  const std::vector<std::string>& names = layout_.header.names;
  return "column " + std::to_string(flag_ + 1) + " '" + printable(names[flag_]) + "' is " +
         join_list(values, "and") + ", and all are read; those of one value: --where " +
         shell_word(column_choice(names, flag_) + "=" + most->first);
}

void refuse_several_sensors(const std::vector<std::string_view>& lines, const std::string& path,
                            const CsvLayout& layout, const ReadOptions& options) {
  if (!options.where.empty()) return;
  const std::vector<std::string>& names = layout.header.names;
  const std::vector<Sensors> columns = unknown_columns(lines, layout);
  for (std::size_t field = 0; field < columns.size(); ++field) {
    const Sensors& column = columns[field];
    if (!column.take_turns()) continue;
    if (!names_sensors(names[field]) && !column.differ(&Sensors::Sensor::rate) &&
        !column.differ(&Sensors::Sensor::temperature)) {
      continue;
    }
    const std::string name = column_choice(names, field);
    std::vector<std::string> values;
    for (const auto& each : column.sensors) values.push_back(printable(each.first));
    throw InputError(path, "rows of several sensors: column " + std::to_string(field + 1) + " '" +
                               printable(names[field]) + "' is " + join(values, ", ") +
                               " in turn; say which: --where " +
                               shell_word(name + "=" + values.front()) + " (or " +
                               shell_word(name + "=*") + " if all rows are of one)");
  }
}

}  // namespace fogcomp::recording
