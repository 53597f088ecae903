#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::bench {

/// The recordings of a case as prepared by `fogcomp fit`.
struct Sight {
  model::Model model;  ///< the declared effects without coefficients; the series refers to it
  series::SignalSeries series{model};
  fog::InputMask inputs = 0;  ///< available in all recordings
  double longest_s = 0;

  Sight(const std::vector<std::string>& declared,
        const std::vector<recording::Recording>& recordings);
  Sight(const Sight&) = delete;
};

/// A contribution (one vector per recording, one value per sample) in the rows of the fit.
Eigen::VectorXd rows_of(const Sight& sight, const std::vector<recording::Recording>& recordings,
                        const std::vector<std::vector<double>>& contributions_dph);

/// The part that a model with the declared effects cannot describe, by least squares over all rows.
class BesideDeclared {
 public:
  /// `truth_dph`: rows of the true contributions of the declared effects, per effect of
  /// sight.model; shape parameters are set to imitate them best.
  BesideDeclared(Sight& sight, const std::vector<Eigen::VectorXd>& truth_dph);

  /// Projects all columns out of the declared regressors.
  Eigen::MatrixXd left_of(const Eigen::MatrixXd& columns) const;
  /// The same, with the time derivative of each regressor, i.e. a small delay: late sensors and
  /// filters are not missing effects.
  Eigen::MatrixXd left_beside_delays(const Eigen::MatrixXd& columns) const;

 private:
  Eigen::MatrixXd basis_;   // orthonormal
  Eigen::MatrixXd delays_;  // orthonormal, with the derivatives
};

/// Imitation of the visible part of a truth by a catalogued effect with its best shape.
struct Imitation {
  std::string effect;
  double fraction = 0;  ///< of the sum of squares, 0 to 1
};

/// For every effect whose inputs the recordings have. Declared effects are skipped, except
/// bias_temperature with an order or two more.
std::vector<Imitation> imitations(const Sight& sight, const BesideDeclared& beside,
                                  const Eigen::VectorXd& left_of_truth);

/// The same for one effect, and for a term, which may be an expression.
double imitation_by(const std::string& effect, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth);
double imitation_by(model::EffectTerm term, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth);

double rms(const Eigen::VectorXd& values);

}  // namespace fogcomp::bench
