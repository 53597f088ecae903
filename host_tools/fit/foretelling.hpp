#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/known_regressors.hpp"
#include "judge/score.hpp"
#include "noise/noise_model.hpp"
#include "recording/row_range.hpp"

namespace fogcomp::fit {

/// Rows that are left out together.
using Part = std::vector<recording::RowRange>;

/// Row weights of a fit, with which two models are compared.
struct JudgedWith {
  const noise::NoiseModel& noise;
  const Eigen::VectorXd& row_weights;
  bool run_offsets = false;
  /// Terms that are refined, of both models: how these bend is what is judged.
  std::vector<std::size_t> refined = {};
};

/// Effects with fitted shapes, and the biases beside them.
struct JudgedEffects {
  const std::vector<model::EffectTerm>& terms;
  const series::Rows& biases;  ///< rows as those that are judged, cut perhaps elsewhere
};

/// A set of effects on the rows of its fit, ready to foretell some of them from the others.
///
/// Coefficients are solved for anew without the rows that are left out; shapes follow to first
/// order. What formulas miss (inexact_terms()) is uncertain as well. What is not determined then
/// has the variance that it may have beforehand, so that nothing has to be refused for want of
/// rows. The noise is that of the effects themselves: white, flicker and a random walk by
/// restricted likelihood in all rows (judge::Prediction). So a walk, or whatever else the effects
/// leave, competes with what another set of effects explains.
class Foretelling {
 public:
  /// Shapes that the terms mark as sought are uncertain. `known` must outlive this.
  Foretelling(const KnownRegressors& known, const JudgedEffects& effects, const JudgedWith& with);

  /// Of the rows of `part`, which are in order; of no others.
  struct OfPart {
    judge::Foretold rows;          ///< each also from those before it
    Eigen::VectorXd residual_dph;  ///< what coefficients and shapes of the others leave
    judge::Promise promise;        ///< of the same

    /// Takes in another part, of which it has no row.
    void join(const OfPart& other);
  };
  OfPart of(const Part& part) const;

  /// Whether any row of `part` counts. Those in which the board's derivative settles do not.
  bool can_foretell(const Part& part) const;

  /// ln of how many shapes the rows tell apart: what a search could choose from.
  double log_choices() const { return log_choices_; }

 private:
  struct Unknowns {
    Eigen::VectorXd change;  // of coefficients, offsets and shapes, from those of all rows
    Eigen::MatrixXd covariance;
  };
  Eigen::VectorXd take_columns(const KnownRegressors& known, const JudgedEffects& effects,
                               const JudgedWith& with);
  judge::Promise promise_of(const Part& part, const Eigen::MatrixXd& of_unknowns) const;
  void foretell(const recording::RowRange& range, Unknowns& unknowns, judge::Foretold& rows) const;

  Eigen::VectorXd drift_dph_;
  Eigen::VectorXd weights_;
  // Derivatives of the drift by coefficients, offsets and shapes, then what the formulas miss.
  Eigen::MatrixXd columns_;
  Eigen::Index fitted_ = 0;       // columns before those
  Eigen::VectorXd residual_dph_;  // with the coefficients of all rows
  Eigen::MatrixXd slopes_;        // unknowns x rows: the columns, whitened
  Eigen::VectorXd surprise_;      // the residual, whitened
  Eigen::VectorXd sigma_;         // standard deviation of each row, given those before
  Eigen::MatrixXd information_;   // of all rows and of what is known beforehand
  Eigen::VectorXd towards_;       // gradient of its logarithm
  double log_choices_ = 0;
};

}  // namespace fogcomp::fit
