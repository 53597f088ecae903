#pragma once

#include "cli/option.hpp"
#include "recording/board_limits.hpp"

namespace fogcomp::cli {

/// Limits of gyro and vehicle: for commands that make a calibration, and for those that read
/// recordings without a model.
struct GyroLimitOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  recording::GivenLimits value() const { return {range.find(), acceleration.find()}; }

  Number range{
      this,
      {"range-dps", "DPS", "full scale of the gyro (default: the model's, or 570)", "", kRare},
      {1e-3, recording::kMaxRangeDps}};
  Number acceleration{this,
                      {"max-acceleration", "DPS2",
                       "no more than it turns, deg/s^2 (the model's, or 20000)", "", kRare},
                      {1e-3, 1e9}};
};

}  // namespace fogcomp::cli
