#pragma once

#include <cstddef>
#include <vector>

#include "compare/branches.hpp"

namespace fogcomp::findings {

/// Columns that a curve over time is cut into: about the pixels of a wide screen.
constexpr std::size_t kColumns = 2000;
/// Points of a cloud: more hide each other.
constexpr std::size_t kCloudPoints = 2000;

/// Curves over one variable that rises.
struct Curves {
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< [curve][point]; NaN: a gap
};

/// `x` rises; each of `y` has as many values; `stretch_starts`: the first row of each stretch
/// without a gap, 0 included. Up to 2 * kColumns rows stay as they are. More are cut into kColumns
/// equal divisions of x, of which each curve keeps the minimum and the maximum in the order in
/// which they come: no spike is lost and none is made up, whatever the number of rows. A gap is a
/// point of NaN.
Curves min_and_max(const std::vector<double>& x, const std::vector<const std::vector<double>*>& y,
                   const std::vector<std::size_t>& stretch_starts);

/// The same for curves that are drawn upon each other: each keeps the mean of a division, so that
/// their sum stays the sum.
Curves column_means(const std::vector<double>& x, const std::vector<const std::vector<double>*>& y,
                    const std::vector<std::size_t>& stretch_starts);

struct Cloud {
  std::vector<double> x;
  std::vector<double> y;
};

/// The rows of one branch as at most about kCloudPoints points, each the mean of `rows_per_point`
/// neighbouring rows.
Cloud thinned(const std::vector<double>& x, const std::vector<double>& y,
              const std::vector<compare::Branch>& branch, compare::Branch wanted,
              std::size_t rows_per_point);

/// That brings `rows` down to kCloudPoints points, at least 1.
std::size_t rows_per_point(std::size_t rows);

}  // namespace fogcomp::findings
