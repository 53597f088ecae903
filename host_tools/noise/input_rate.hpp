#pragma once

#include <Eigen/Core>

#include "series/rows.hpp"

namespace fogcomp::noise {

/// What an error of the input rate can be made of, row by row: the rate itself, by powers of it,
/// with the temperature, its size, its change, and what a nonlinearity makes of a change within a
/// row. Dimensionless; rows x 0 where the rate never changes.
Eigen::MatrixXd input_rate_columns(const Eigen::VectorXd& input_rate_dph,
                                   const Eigen::VectorXd& temperature_degc);
Eigen::MatrixXd input_rate_columns(const series::Rows& rows);

/// A residual less what these columns explain of it, rows with a weight of 0 not asked: what of it
/// may be noise. As given where the rate never changes.
Eigen::VectorXd without_input_rate(const series::Rows& rows, const Eigen::VectorXd& residual,
                                   const Eigen::VectorXd& weights);

}  // namespace fogcomp::noise
