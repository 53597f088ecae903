#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::bench {

/// The recordings of a case as `fogcomp fit` sees them.
struct Sight {
  model::Model model;  ///< the declared effects, no coefficients; the series points to it
  series::SignalSeries series{model};
  fog::InputMask inputs = 0;  ///< that all recordings have
  double longest_s = 0;

  Sight(const std::vector<std::string>& declared,
        const std::vector<recording::Recording>& recordings);
  Sight(const Sight&) = delete;
};

/// A contribution (a vector per recording, a value per sample) in the rows of the fit.
Eigen::VectorXd rows_of(const Sight& sight, const std::vector<recording::Recording>& recordings,
                        const std::vector<std::vector<double>>& contributions_dph);

/// What a model with the declared effects cannot take up, by least squares over all rows.
class BesideDeclared {
 public:
  /// `truth_dph`: rows of what the declared effects really contribute, per effect of sight.model;
  /// shape parameters are put where they imitate it best.
  BesideDeclared(Sight& sight, const std::vector<Eigen::VectorXd>& truth_dph);

  /// Every column less its projection on the declared regressors.
  Eigen::MatrixXd left_of(const Eigen::MatrixXd& columns) const;
  /// The same, less what a small delay of each regressor (its derivative in time) takes up too:
  /// late sensors and filters are no missing effect.
  Eigen::MatrixXd left_beside_delays(const Eigen::MatrixXd& columns) const;

 private:
  Eigen::MatrixXd basis_;   // orthonormal columns
  Eigen::MatrixXd delays_;  // and those with the derivatives
};

/// How well an effect of the catalogue, with its best shape, imitates what is left of a truth.
struct Imitation {
  std::string effect;
  double fraction = 0;  ///< of the sum of squares, 0 to 1
};

/// For every effect that the recordings have the inputs for. One that is declared already counts
/// only as bias_temperature of an order or two more.
std::vector<Imitation> imitations(const Sight& sight, const BesideDeclared& beside,
                                  const Eigen::VectorXd& left_of_truth);

/// The same of one effect, and of a term, which may be an expression.
double imitation_by(const std::string& effect, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth);
double imitation_by(model::EffectTerm term, const Sight& sight, const BesideDeclared& beside,
                    const Eigen::VectorXd& left_of_truth);

double rms(const Eigen::VectorXd& values);

}  // namespace fogcomp::bench
