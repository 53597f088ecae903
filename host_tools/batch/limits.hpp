#pragma once

#include <string>
#include <vector>

#include "batch/gyro_result.hpp"

namespace fogcomp::batch {

/// A limit of a value: "holdout_drift_dph <= 0.01".
struct Limit {
  std::string figure;
  bool is_max = true;  ///< else a lower limit
  double value = 0;

  bool meets(double figure_value) const {
    return is_max ? figure_value <= value : figure_value >= value;
  }
};

/// Parses a limits file: one `FIGURE <= NUMBER` or `FIGURE >= NUMBER` per line, `#` comments.
/// Throws InputError with file and line; for a name that is not in `known`, with the nearest one.
std::vector<Limit> parse_limits(const std::string& text, const std::string& file,
                                const std::vector<std::string>& known);

/// The limits that a gyro violates, as text, separated by "; "; "" if none. A missing value
/// violates its limit.
std::string broken_limits(const GyroResult& result, const std::vector<Limit>& limits);

}  // namespace fogcomp::batch
