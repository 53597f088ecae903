#pragma once

#include <array>
#include <vector>

#include "core/signal/inputs.hpp"
#include "dataset/columns.hpp"

namespace fogcomp {

/// The column of a recording that holds an input of the drift model.
inline constexpr std::array<Column, fog::kInputs> kInputColumns{
    Column::temperature2_degc, Column::magnetic_ut,    Column::light_power_uw, Column::supply_v,
    Column::vibration_grms,    Column::input_rate_dph, Column::time_s};

constexpr const ColumnInfo& input_column(fog::Input input) {
  return column_info(kInputColumns[static_cast<std::size_t>(input)]);
}

/// Values of extension input `i`; empty where the recording does not have it.
inline const std::vector<double>& extension_column(const Recording& recording, std::size_t i) {
  return recording.*input_column(static_cast<fog::Input>(i)).values;
}

}  // namespace fogcomp
