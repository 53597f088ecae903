#pragma once

#include <Eigen/Core>
#include <optional>

#include "fit/foretelling.hpp"
#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::fit {

/// Where a fit has its biases of power-ons.
struct BiasColumns {
  std::optional<Eigen::Index> bias;  ///< coefficient of the model's bias
  series::ColumnRange offsets;       ///< of the second, third... bias against the first
  Eigen::VectorXd shares;            ///< of each bias in the model's; their sum is 1
};

/// How far a gyro's bias spreads from one power-on to the next.
struct TurnOnRepeatability {
  double dph = 0;     ///< standard deviation
  double chance = 1;  ///< that power-ons of one bias show such a spread
};

/// The spread that is most likely beside the effects of a fit (restricted maximum likelihood,
/// Patterson & Thompson 1971); 0 if noise explains it. `covariance`: that of predict() of
/// the fit, which has slow noise and missing effects; empty if the effects are not determined
/// beside the offsets: then the noise of the fit alone counts. The chance is that of the ratio of
/// likelihoods (Self & Liang 1987), too large for few power-ons.
TurnOnRepeatability turn_on_repeatability(const NoiseWeightedFit& fit,
                                          const series::ColumnRange& offsets,
                                          const Eigen::MatrixXd& covariance);

/// Chance that biases of power-ons alone, of any spread, would look like what `after` explains more
/// than `before` of the differences between them (variance ratio test; a shape that is sought is as
/// many tries as values are tried of it). 0 if it is determined within recordings, 1 if it leaves
/// none to judge it. Both with coefficients; `with`: noise and weights of the rows.
double chance_of_biases(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                        const std::vector<model::EffectTerm>& after, const JudgedWith& with);

/// Covariance of so many offsets against the first power-on, for biases of variance 1.
Eigen::MatrixXd covariance_of_offsets(Eigen::Index offsets);

/// Restates a fit that knew nothing of the offsets for power-ons whose biases spread by
/// `repeatability_dph` (random effects; best linear unbiased prediction, Henderson 1975). So
/// effects are found within the recordings as far as these show them, and between them as well as
/// biases that vary allow: recordings at one temperature each tell a drift with temperature. Shapes
/// are those found. Changes coefficients, residuals and covariance of the fit, and `covariance`,
/// which is that of predict(). In the fit's covariance the bias is the mean of these
/// power-ons, by their shares, in the other that of all to come; the coefficient stays the first's.
void expect_repeatability(double repeatability_dph, const BiasColumns& columns,
                          NoiseWeightedFit& fit, Eigen::MatrixXd& covariance);

}  // namespace fogcomp::fit
