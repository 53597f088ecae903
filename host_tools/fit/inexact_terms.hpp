#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"
#include "series/rows.hpp"

namespace fogcomp::fit {

/// What a gyro may do beside the formulas of a model's terms, a column for each, of one standard
/// deviation, deg/h: a sensor that leads or lags the coil, drift of the rate through other lags, a
/// bend of each term with temperature. `columns`: rows x at least the terms' regressors;
/// `coefficients`: theirs.
Eigen::MatrixXd inexact_terms(const series::Rows& rows, const std::vector<model::EffectTerm>& terms,
                              const Eigen::MatrixXd& columns, const Eigen::VectorXd& coefficients);

/// Of these what no change of the terms' coefficients can do: the drift of the temperature rate
/// follows the rate early, late, or through other lags. A sensor that leads or lags the coil
/// otherwise is part of a rate coefficient.
Eigen::MatrixXd inexact_rate_terms(const series::Rows& rows,
                                   const std::vector<model::EffectTerm>& terms,
                                   const Eigen::MatrixXd& columns,
                                   const Eigen::VectorXd& coefficients);

}  // namespace fogcomp::fit
