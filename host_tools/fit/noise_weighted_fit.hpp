#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/prior.hpp"
#include "fit/shape_search.hpp"
#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {

/// Effects solved for together, with rows weighted by their noise.
struct NoiseWeightedFit {
  std::vector<model::EffectTerm> terms;       ///< as given, with optimised shape parameters
  std::vector<model::ShapeParameter> shapes;  ///< the optimised parameters
  noise::NoiseModel noise;      ///< noise used for the weights; at least that of rounding
  Eigen::VectorXd robust;       ///< 1; 0 for outliers and excluded rows
  Eigen::VectorXd noise_scale;  ///< noise_scale(), relative to the rows of `noise`
  Eigen::VectorXd row_weights;  ///< time covered by a row, times `robust`, over its noise variance
  std::size_t outliers = 0;     ///< rows left out as such (outlier_rows.hpp)

  Eigen::MatrixXd columns;        ///< rows x linear: regressors of all terms, then nuisance columns
  Eigen::VectorXd coefficients;   ///< linear
  Eigen::VectorXd residual_dph;   ///< per row
  Eigen::MatrixXd shape_columns;  ///< rows x shapes: derivatives of the drift by their positions

  std::optional<Prior> prior;  ///< nothing: none
  /// The whitened columns, then one per shape parameter; behind the rows, those of the prior.
  Eigen::MatrixXd whitened;
  Eigen::VectorXd whitened_measured;  ///< noise variance 1
  Eigen::VectorXd whitened_residual;
  Eigen::MatrixXd covariance;  ///< of coefficients and shapes (0..1); empty if rank deficient

  Eigen::Index linear() const { return columns.cols(); }
  /// row_weights if only the rows of `kept` (1, else 0) count.
  Eigen::VectorXd weights_of(const series::Rows& rows, const Eigen::VectorXd& kept) const;
  /// rms of the whitened residual: 1 if only that noise is left.
  double birge_ratio() const;
};

struct RowSettings {
  /// 1 per row, 0 for excluded rows; empty: all are used.
  Eigen::VectorXd kept;
  std::optional<noise::NoiseModel> noise;  ///< used instead of an estimate
  bool shapes_found = false;  ///< the shapes are near their minimum: no range is searched
  std::function<void(double)> progress{};  ///< called with the fraction done, 0..1; may be empty
  const Prior* prior = nullptr;  ///< of the terms' unknowns; no range is searched with one
};

/// Solves for the coefficients of `terms` and of the nuisance columns (rows x any number), and for
/// the shape parameters that the terms mark. Three iterations of: noise from the quiet parts of the
/// residual, shapes by variable projection. Outliers have weight 0. Linearly dependent columns are
/// allowed: see `covariance`.
NoiseWeightedFit fit_rows(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance, const RowSettings& settings = {});

/// The same for fits whose coefficients are used: throws InputError for too few rows, and if the
/// rows do not determine a coefficient or a shape (undetermined.hpp).
NoiseWeightedFit fit_determined(const KnownRegressors& known,
                                const std::vector<model::EffectTerm>& terms,
                                const Eigen::MatrixXd& nuisance, const RowSettings& settings = {});

/// 1 in these rows, else 0.
Eigen::VectorXd ones_in(const series::Rows& rows, const recording::RowRange& range);

/// 1 from a row to the end of its recording, else 0.
Eigen::VectorXd step_column(const series::Rows& rows, std::size_t row);

/// Whether each of Rows::bias_ranges() has a bias of its own: if that is wanted, or a run is cut.
bool has_own_biases(const series::Rows& rows, bool wanted);

/// Rows x (biases - 1): ones in the second, third... of Rows::bias_ranges() each. No columns if
/// they have one bias.
Eigen::MatrixXd run_offset_columns(const series::Rows& rows, bool wanted = true);

}  // namespace fogcomp::fit
