#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "judge/mode_bands.hpp"
#include "judge/prediction.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::planning {

/// Inner products over rows in which each counts by what the noise leaves of it.
class WeightedRows {
 public:
  WeightedRows(const std::vector<recording::RowRange>& stretches, double row_s,
               const judge::NoiseLevels& noise);

  /// left^T W right, W the inverse of the noise's covariance, (deg/h)^-2.
  Eigen::MatrixXd products(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) const;

 private:
  judge::ModeBands bands_;
  Eigen::VectorXd weights_;  // of each band: inverse variance of a mode
};

/// The rows of a series with these columns, none of which has a prior.
judge::Rows rows_with(const series::SignalSeries& series, Eigen::MatrixXd columns);

/// An effect of the catalogue and the size from which rows show it.
struct VisibleSize {
  std::string effect;
  double typical_dph = 0;  ///< rms, in the size of the catalogue's example
  double visible_dph = 0;  ///< the same measure at three standard deviations; infinite: never
};

/// Rms error of a fitted drift.
struct DriftError {
  double noise_dph = 0;     ///< the noise of the rows that were fitted
  double formulas_dph = 0;  ///< what the effects' formulas leave out

  double sigma_dph() const;
};

/// What rows tell of effects in a noise: by the information that they have on each coefficient and
/// shape, nearly nothing being known before. Needs no measured rate.
class Information {
 public:
  /// The first `recorded` rows of `series` tell; what they tell is measured on those behind them,
  /// or on themselves where there are none. `terms`: with coefficients. All but `noise` must
  /// outlive this.
  Information(const series::SignalSeries& series, const std::vector<model::EffectTerm>& terms,
              const judge::NoiseLevels& noise, Eigen::Index recorded);

  /// Of least squares with the terms' formulas, on rows that have noise and follow others
  /// (fit/inexact_terms.hpp).
  DriftError error() const;
  /// From which size on a term differs from all that the others do, shapes and inexact formulas
  /// included. `term`: in its typical size.
  VisibleSize visible(const model::EffectTerm& term) const;
  /// Of all effects of the catalogue whose inputs are in `inputs`, and which these move.
  std::vector<VisibleSize> visible_of_catalogue(fog::InputMask inputs) const;

 private:
  void set_columns();
  Eigen::MatrixXd measured(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd information_of(const Eigen::MatrixXd& columns) const;

  const series::SignalSeries& series_;
  const std::vector<model::EffectTerm>& terms_;
  Eigen::Index recorded_;
  WeightedRows rows_;
  Eigen::MatrixXd columns_;  // each in units of what it may be beforehand
  Eigen::MatrixXd inexact_;
  std::vector<std::string> owners_;  // of each column: the name of its effect
};

}  // namespace fogcomp::planning
