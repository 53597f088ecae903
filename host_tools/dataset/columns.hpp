#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "dataset/recording.hpp"
#include "dataset/recording_writer.hpp"

namespace fogcomp {

/// A column of a recording: its name in a file, its place in memory, and how it is printed.
struct ColumnInfo {
  Column column;
  std::string_view name;
  std::vector<double> Recording::*values;
  /// Decimals in a CSV: finer than any sensor of the quantity. 1 us of time numbers samples up to
  /// 500 kHz; 1e-5 degC is below half an LSB of the sensor stream (2^-16 degC), and 1e-6 deg/h
  /// below a thousandth of its rate LSB (2^-10 deg/h), so stream -> CSV -> stream gives back the
  /// counts.
  int decimals;
  /// What a sensor can mean; beyond lies a wrong unit, or a mark for "no value" such as -999.
  double least;
  double most;

  constexpr bool can_be(double value) const { return value >= least && value <= most; }
};

/// In the order of the enum.
inline constexpr std::array<ColumnInfo, 9> kColumns{{
    {Column::time_s, "time_s", &Recording::time_s, 6, -1e12, 1e12},
    {Column::temperature_degc, "temperature_degc", &Recording::temperature_degc, 5, -273.15, 1000},
    {Column::rate_dph, "rate_dph", &Recording::rate_dph, 6, -1e9, 1e9},
    {Column::input_rate_dph, "input_rate_dph", &Recording::input_rate_dph, 6, -1e9, 1e9},
    {Column::temperature2_degc, "temperature2_degc", &Recording::temperature2_degc, 5, -273.15,
     1000},
    {Column::magnetic_ut, "magnetic_ut", &Recording::magnetic_ut, 5, -1e9, 1e9},
    {Column::light_power_uw, "light_power_uw", &Recording::light_power_uw, 5, -1e9, 1e9},
    {Column::supply_v, "supply_v", &Recording::supply_v, 6, -1e6, 1e6},
    {Column::vibration_grms, "vibration_grms", &Recording::vibration_grms, 6, -1e6, 1e6},
}};

constexpr const ColumnInfo& column_info(Column column) {
  return kColumns[static_cast<std::size_t>(column)];
}

}  // namespace fogcomp
