#pragma once

#include <algorithm>
#include <functional>

#include "series/signal_series.hpp"

namespace fog::test {

/// One recording of so many rows whose temperature is `temperature_degc`(row); its rate in each row
/// is that to the row before. No drift, full weight.
inline fogcomp::series::Rows made_rows(std::size_t count,
                                       const std::function<double(double)>& temperature_degc,
                                       double row_s = 10) {
  fogcomp::series::Rows rows;
  rows.row_s = row_s;
  rows.drift_dph = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  rows.weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(count));
  rows.run_starts = {0};
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<double>(i);
    rows.time_s.push_back(row_s * row);
    fog::Signals<fogcomp::model::RealNumbers> signals;
    signals.temperature = temperature_degc(row);
    signals.temperature_rate =
        i == 0 ? 0 : (temperature_degc(row) - temperature_degc(row - 1)) * 60 / row_s;
    signals.block.temperature = signals.temperature;
    signals.block.elapsed = row;
    rows.signals.push_back(signals);
    rows.inputs.push_back(signals.block);
  }
  return rows;
}

/// A soak of `soak` rows, a ramp of `ramp` rows at 1 degC/min, a soak as long as the first.
inline fogcomp::series::Rows soak_ramp_soak(std::size_t soak, std::size_t ramp, double row_s = 10) {
  return made_rows(
      2 * soak + ramp,
      [=](double row) {
        const double in_ramp = row - static_cast<double>(soak) + 1;
        return 20 + std::clamp(in_ramp, 0.0, static_cast<double>(ramp)) * row_s / 60;
      },
      row_s);
}

}  // namespace fog::test
