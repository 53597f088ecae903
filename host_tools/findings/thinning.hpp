#pragma once

#include <cstddef>
#include <vector>

#include "compare/dependence.hpp"

namespace fogcomp::findings {

/// Divisions of a curve over time: about the pixels of a wide screen.
constexpr std::size_t kColumns = 2000;
/// Points of a cloud: more would hide each other.
constexpr std::size_t kCloudPoints = 2000;

/// Curves over one rising variable.
struct Curves {
  std::vector<double> x;
  std::vector<std::vector<double>> y;  ///< [curve][point]; NaN: a gap
};

/// `x` rises; each of `y` has as many values; `stretch_starts`: first row of each stretch without a
/// gap, 0 included. Up to 2 * kColumns rows are kept. More are divided into kColumns equal parts of
/// x, of which each curve keeps minimum and maximum in their order: no spike is lost or invented. A
/// gap is a point of NaN.
Curves min_and_max(const std::vector<double>& x, const std::vector<const std::vector<double>*>& y,
                   const std::vector<std::size_t>& stretch_starts);

/// The same for stacked curves: each keeps the mean of a part, so that their sum is right.
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

/// Number that reduces `rows` to kCloudPoints points, at least 1.
std::size_t rows_per_point(std::size_t rows);

}  // namespace fogcomp::findings
