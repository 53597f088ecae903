#pragma once

#include <Eigen/Core>
#include <vector>

#include "recording/row_range.hpp"

namespace fogcomp::judge {

/// Sums of products of columns over bands of cosine modes. The spectrum of noise hardly changes
/// within a band, so that they replace the rows: a likelihood takes microseconds.
struct ModeBands {
  Eigen::ArrayXd angle;  ///< per row, geometric mean of the band
  Eigen::ArrayXd count;  ///< modes
  /// Products of the columns i <= j, column j by column j, x bands.
  Eigen::MatrixXd products;
  Eigen::Index columns = 0;
};

/// `columns`: rows x any number; `stretches`: evenly spaced rows. The mean of a stretch is at half
/// the angle of its first mode, where a random walk has its variance within a fifth.
ModeBands mode_bands(const Eigen::MatrixXd& columns,
                     const std::vector<recording::RowRange>& stretches);

/// Weighted sum of the products as a symmetric matrix.
Eigen::MatrixXd weighted_products(const ModeBands& bands, const Eigen::VectorXd& weighted);

}  // namespace fogcomp::judge
