#include "series/row_filters.hpp"

#include <cmath>

namespace fogcomp::series {
namespace {

// Equals fog::FirstOrderLag for rows spaced like the board's blocks; handles any spacing.
void step(const Rows& rows, double tau_s, Eigen::Index from, Eigen::Index to,
          Eigen::VectorXd& values) {
  const double elapsed_s = std::abs(rows.time_s[static_cast<std::size_t>(to)] -
                                    rows.time_s[static_cast<std::size_t>(from)]);
  values[to] = values[from] - std::expm1(-elapsed_s / tau_s) * (values[to] - values[from]);
}

}  // namespace

Eigen::VectorXd first_order_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s) {
  Eigen::VectorXd result = values;
  for (Eigen::Index i = 1; i < result.size(); ++i) {
    if (!rows.starts_run(static_cast<std::size_t>(i))) step(rows, tau_s, i - 1, i, result);
  }
  return result;
}

Eigen::VectorXd smoothed(const Rows& rows, const Eigen::VectorXd& values, double tau_s) {
  Eigen::VectorXd result = first_order_lag(rows, values, tau_s);
  for (Eigen::Index i = result.size() - 1; i > 0; --i) {
    if (!rows.starts_run(static_cast<std::size_t>(i))) step(rows, tau_s, i, i - 1, result);
  }
  return result;
}

}  // namespace fogcomp::series
