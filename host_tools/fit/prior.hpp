#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "judge/prediction.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// What an older model, or a lot, knows of a gyro before a fit: a Gaussian distribution of its
/// coefficients, term by term, and of the positions of its shapes in their ranges behind them.
struct Prior {
  std::string file;                      ///< of the older model, or of the lot
  std::size_t gyros = 0;                 ///< of the lot; 0: an older model of the gyro itself
  std::vector<model::EffectTerm> terms;  ///< those to be fitted, with the mean's values
  Eigen::VectorXd board_mean;            ///< of what compensates best on a board
  Eigen::VectorXd gyro_mean;             ///< of the gyro's own values
  Eigen::MatrixXd covariance;            ///< of both
  judge::NoiseLevels noise;              ///< beside them; white: of a row of `row_s`
  double row_s = 0;

  const Eigen::VectorXd& mean(series::Reading reading) const;
  Eigen::Index coefficients() const;  ///< number; the rest are shapes
};

/// Noise of the rows that a model was fitted to, which has uncertainties.
judge::NoiseLevels noise_of(const model::Model& model);

/// Of a fitted model, for a run to come: its bias has the spread from power-on to power-on besides.
/// `file`: for messages. Throws InputError for a model without uncertainties, or with an event.
Prior prior_of(const model::Model& model, const std::string& file);

/// The unknowns of terms as they are: coefficients, then positions of their shapes.
Eigen::VectorXd unknowns_in(const std::vector<model::EffectTerm>& terms);
/// The same of the gyro's own values.
Eigen::VectorXd own_unknowns_in(const std::vector<model::EffectTerm>& terms);

/// `EFFECT.COEFFICIENT` or `EFFECT.PARAMETER` of each unknown.
std::vector<std::string> names_of_unknowns(const std::vector<model::EffectTerm>& terms);

/// The unknowns of a prior in others, which are independent, of variance 1 and mean 0 before the
/// fit: unknowns = origin + slopes * others. Shapes depend on the last of them alone, so that
/// coefficients about shapes that are already found stay a linear problem.
struct Independent {
  Eigen::VectorXd origin;
  Eigen::MatrixXd slopes;
};
/// `positions`: of the shapes that are found.
Independent independent(const Prior& prior, series::Reading reading,
                        const Eigen::VectorXd& positions);

}  // namespace fogcomp::fit
