#include "series/row_filters.hpp"

#include <cmath>

namespace fogcomp {

Eigen::VectorXd behind_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s) {
  Eigen::VectorXd result(values.size());
  double state = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (rows.starts_run(row)) {
      state = values[i];
    } else {
      const double elapsed_s = rows.time_s[row] - rows.time_s[row - 1];
      state += -std::expm1(-elapsed_s / tau_s) * (values[i] - state);
    }
    result[i] = values[i] - state;
  }
  return result;
}

}  // namespace fogcomp
