#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"
#include "series/rows.hpp"

namespace fogcomp::fit {

/// What a gyro may do beside the formulas of a model's terms, a column for each, of one standard
/// deviation, deg/h: a sensor that leads or lags the coil, drift of the rate through other lags, a
/// bend of each term with temperature, but for the terms `straight`. `columns`: rows x at least the
/// terms' regressors; `coefficients`: theirs.
Eigen::MatrixXd inexact_terms(const series::Rows& rows, const std::vector<model::EffectTerm>& terms,
                              const Eigen::MatrixXd& columns, const Eigen::VectorXd& coefficients,
                              const std::vector<std::size_t>& straight = {});

/// Of these what no change of the terms' coefficients can do: the drift of the temperature rate
/// follows the rate early, late, or through other lags. A sensor that leads or lags the coil
/// otherwise is part of a rate coefficient.
Eigen::MatrixXd inexact_rate_terms(const series::Rows& rows,
                                   const std::vector<model::EffectTerm>& terms,
                                   const Eigen::MatrixXd& columns,
                                   const Eigen::VectorXd& coefficients);

/// What the terms' drift does within `time_s`, in which a thermometer does not tell what the
/// temperature does, to second order: by so much more or less, one standard deviation, it follows
/// each turn of the temperature, and what is left of the thermometer's noise.
Eigen::VectorXd unresolved_drift(const series::Rows& rows,
                                 const std::vector<model::EffectTerm>& terms,
                                 const Eigen::MatrixXd& columns,
                                 const Eigen::VectorXd& coefficients, double time_s);

}  // namespace fogcomp::fit
