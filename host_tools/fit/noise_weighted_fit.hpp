#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "fit/shape_search.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {

/// Effects solved for together, rows weighted with their noise.
struct NoiseWeightedFit {
  std::vector<model::EffectTerm> terms;  ///< as given, shape parameters where the cost is smallest
  std::vector<model::ShapeParameter> shapes;  ///< those that were moved
  noise::NoiseModel noise;      ///< what the rows were weighted with; at least what rounding makes
  Eigen::VectorXd robust;       ///< 1; 0 for outliers and rows that are left out
  Eigen::VectorXd noise_scale;  ///< noise_scale(), relative to the rows of `noise`
  Eigen::VectorXd row_weights;  ///< time behind a row, times that, by its own noise's variance
  std::size_t outliers = 0;     ///< rows left out as such (outlier_rows.hpp)

  Eigen::MatrixXd columns;       ///< rows x linear: regressors of all terms, then the nuisance
  Eigen::VectorXd coefficients;  ///< linear
  Eigen::VectorXd residual_dph;  ///< per row

  Eigen::MatrixXd whitened;           ///< the columns whitened, then a column per shape parameter
  Eigen::VectorXd whitened_measured;  ///< rows of noise variance 1
  Eigen::VectorXd whitened_residual;
  Eigen::MatrixXd covariance;  ///< of coefficients and shapes (0..1); empty where rank is lacking

  Eigen::Index linear() const { return columns.cols(); }
  /// rms of the whitened residual: 1 where only that noise is left.
  double birge_ratio() const;
};

struct RowSettings {
  /// 1 per row, 0 for rows that count for nothing; empty: all count.
  Eigen::VectorXd kept;
  std::optional<noise::NoiseModel> noise;  ///< taken as it is instead of being estimated
  bool shapes_found = false;               ///< the same rows, with a noise that is better known
  std::function<void(double)> progress{};  ///< told how much is done, 0..1; or empty
};

/// Solves for the coefficients of `terms` and of the nuisance columns (rows x any), and for those
/// shape parameters that the terms mark. Three rounds of: noise from the quiet parts of what is
/// left, shapes by variable projection. Outliers count for nothing. Columns that depend on each
/// other are no error here: see `covariance`.
NoiseWeightedFit fit_rows(const series::SignalSeries& series,
                          const std::vector<model::EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance, const RowSettings& settings = {});

/// The same for a fit whose coefficients are wanted: throws InputError for too few rows, and where
/// the rows do not determine a coefficient or a shape (undetermined.hpp).
NoiseWeightedFit fit_determined(const series::SignalSeries& series,
                                const std::vector<model::EffectTerm>& terms,
                                const Eigen::MatrixXd& nuisance, const Eigen::VectorXd& kept,
                                const std::function<void(double)>& progress = {});

/// 1 from a row to the end of its recording, else 0.
Eigen::VectorXd step_column(const series::Rows& rows, std::size_t row);

/// Rows x (recordings - 1): ones in the second, third... recording each. No columns unless
/// `wanted`.
Eigen::MatrixXd run_offset_columns(const series::Rows& rows, bool wanted = true);

}  // namespace fogcomp::fit
