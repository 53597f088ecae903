#pragma once

#include <Eigen/Core>

#include "series/rows.hpp"

namespace fogcomp::noise {

/// Regressors of errors of the input rate, row by row: the rate (first), its powers, its products
/// with temperature and with the temperature's change (a part that is warmed late), its magnitude,
/// its change (a late record, to second order, and with temperature), and the effect of a
/// nonlinearity on a change within a row. `per_row`: values in one row as it is fitted.
/// Dimensionless; rows x 0 if the rate is constant.
Eigen::MatrixXd input_rate_columns(const Eigen::Ref<const Eigen::VectorXd>& input_rate_dph,
                                   const Eigen::Ref<const Eigen::VectorXd>& temperature_degc,
                                   Eigen::Index per_row);
/// Of rows as they are fitted.
Eigen::MatrixXd input_rate_columns(const series::Rows& rows);

/// Fraction of the variance of `values` that these columns explain, 0..1. Some of it by chance:
/// about columns / rows of white noise.
double share_of_input_rate(Eigen::MatrixXd columns, const Eigen::VectorXd& values);

/// A residual less the part explained by these columns, fitted without rows of weight 0: the part
/// that may be noise. Unchanged if the rate is constant.
Eigen::VectorXd without_input_rate(const series::Rows& rows, const Eigen::VectorXd& residual,
                                   const Eigen::VectorXd& weights);

}  // namespace fogcomp::noise
