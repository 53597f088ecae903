#pragma once

#include <string>
#include <vector>

#include "batch/gyro_result.hpp"

namespace fogcomp::batch {

/// What a figure must keep: "holdout_drift_dph <= 0.01".
struct Limit {
  std::string figure;
  bool is_max = true;  ///< else a lower limit
  double value = 0;

  bool keeps(double figure_value) const {
    return is_max ? figure_value <= value : figure_value >= value;
  }
};

/// Reads a limits file: `FIGURE <= NUMBER` or `FIGURE >= NUMBER` a line, `#` comments. Throws
/// InputError naming file and line, and for a figure that is not among `known`, the nearest one.
std::vector<Limit> parse_limits(const std::string& text, const std::string& file,
                                const std::vector<std::string>& known);

/// What a gyro breaks, in words, "; " between; "" where it keeps all. A figure that it does not
/// have is not kept.
std::string broken_limits(const GyroResult& result, const std::vector<Limit>& limits);

}  // namespace fogcomp::batch
