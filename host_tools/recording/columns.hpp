#pragma once

#include <array>
#include <string_view>

#include "core/signal/inputs.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// A column of a recording: its name in a file, how it is printed, and its limits.
struct ColumnInfo {
  Column column;
  std::string_view name;
  int decimals;  ///< as in InputDescription
  double min;
  double max;

  constexpr bool can_be(double value) const { return value >= min && value <= max; }
};

/// The column of a recording for an input of the drift model.
constexpr Column column_of(fog::Input input) {
  if (input == fog::Input::elapsed) return Column::time_s;
  if (input == fog::Input::temperature) return Column::temperature_degc;
  if (input == fog::Input::input_rate) return Column::input_rate_dph;
  return static_cast<Column>(kFirstExtensionColumn + extension_number(input));
}

/// In the order of the enum.
inline constexpr auto kColumns = [] {
  std::array<ColumnInfo, kFirstExtensionColumn + fog::kExtensionInputs> columns{};
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (input.column[0] == '\0') continue;
    const Column column = column_of(input.input);
    columns[static_cast<std::size_t>(column)] = {column, input.column, input.decimals,
                                                 static_cast<double>(input.min_milli) / 1000,
                                                 static_cast<double>(input.max_milli) / 1000};
  }
  columns[static_cast<std::size_t>(Column::rate_dph)] = {Column::rate_dph, "rate_dph", 6, -1e9,
                                                         1e9};
  columns[static_cast<std::size_t>(Column::uptime_s)] = {Column::uptime_s, "uptime_s", 6, 0, 1e12};
  return columns;
}();

/// Index into kColumns.
constexpr std::size_t slot_of(Column column) {
  return static_cast<std::size_t>(column);
}
constexpr std::size_t kTimeSlot = slot_of(Column::time_s);
constexpr std::size_t kTemperatureSlot = slot_of(Column::temperature_degc);
constexpr std::size_t kRateSlot = slot_of(Column::rate_dph);
constexpr std::size_t kInputRateSlot = slot_of(Column::input_rate_dph);

constexpr const ColumnInfo& column_info(Column column) {
  return kColumns[static_cast<std::size_t>(column)];
}

}  // namespace fogcomp::recording
