#pragma once

#include <Eigen/Core>

namespace fogcomp {

/// Weighted linear least squares by column-pivoting QR.
struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::VectorXd sigma;     ///< one standard deviation, residual taken as white
  Eigen::VectorXd residual;  ///< measured - fitted, per row
  double rms = 0;            ///< weighted, of the residual
  Eigen::Index rank = 0;     ///< below coefficients.size(): columns depend on each other
};

/// rows x columns matrix, one value and one weight (> 0) per row.
LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values,
                       const Eigen::VectorXd& weights);

}  // namespace fogcomp
