#include "series/edge_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fogcomp::series {

double value_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i) {
  const auto bend = [&](std::ptrdiff_t k) {
    if (k < 1 || k + 1 >= size) return std::numeric_limits<double>::infinity();
    return std::abs(stretch[k - 1] - 2 * stretch[k] + stretch[k + 1]);
  };
  const double* const at = stretch + i;
  const bool has_two_before = i >= 1;
  const bool has_two_after = i + 2 < size;
  if (i < 0) return has_two_after ? (3 * at[1] - at[2]) / 2 : at[1];
  if (i + 1 == size) return has_two_before ? (3 * at[0] - at[-1]) / 2 : at[0];
  const double across = std::max(bend(i), bend(i + 1));
  const double before = bend(i - 1);
  const double after = bend(i + 2);
  if (before < across && before <= after) return (3 * at[0] - at[-1]) / 2;
  if (after < across) return (3 * at[1] - at[2]) / 2;
  return (at[0] + at[1]) / 2;
}

}  // namespace fogcomp::series
