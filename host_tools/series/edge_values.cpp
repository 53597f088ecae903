#include "series/edge_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "series/decision_rules.hpp"

namespace fogcomp::series {
namespace {

// Whether the second differences at four samples are those of a smooth curve: without a corner
// they change evenly from one to the next.
bool is_smooth(const std::array<double, 4>& bends) {
  double max_bend = 0;
  for (const double bend : bends) max_bend = std::max(max_bend, std::abs(bend));
  const double unevenness = std::max(std::abs(bends[0] - 2 * bends[1] + bends[2]),
                                     std::abs(bends[1] - 2 * bends[2] + bends[3]));
  return std::isfinite(max_bend) && unevenness <= rules::kMaxUnevenness * max_bend;
}

// The straight line through two neighbouring means, between them and at its ends.
Edge between(double a, double b) {
  return {(a + b) / 2, b - a};
}
Edge behind(double a, double b) {
  return {(3 * b - a) / 2, b - a};
}
Edge before(double a, double b) {
  return {(3 * a - b) / 2, b - a};
}

}  // namespace

Edge edge_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i) {
  const auto bend = [&](std::ptrdiff_t k) {
    if (k < 1 || k + 1 >= size) return std::numeric_limits<double>::infinity();
    return stretch[k - 1] - 2 * stretch[k] + stretch[k + 1];
  };
  const double* const at = stretch + i;
  if (i < 0) return i + 2 < size ? before(at[1], at[2]) : Edge{at[1]};
  if (i + 1 == size) return i >= 1 ? behind(at[-1], at[0]) : Edge{at[0]};
  const std::array<double, 4> bends{bend(i - 1), bend(i), bend(i + 1), bend(i + 2)};
  if (is_smooth(bends)) {
    return {(7 * (at[0] + at[1]) - at[-1] - at[2]) / 12,
            (15 * (at[1] - at[0]) - (at[2] - at[-1])) / 12};
  }
  const double bend_before = std::abs(bends[0]);
  const double bend_across = std::max(std::abs(bends[1]), std::abs(bends[2]));
  const double bend_after = std::abs(bends[3]);
  if (bend_before < bend_across && bend_before <= bend_after) return behind(at[-1], at[0]);
  if (bend_after < bend_across) return before(at[1], at[2]);
  return between(at[0], at[1]);
}

}  // namespace fogcomp::series
