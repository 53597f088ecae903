#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "judge/at_noise.hpp"
#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// log(e^a + e^b).
double log_add(double a, double b);

/// Logarithm of a probability relative to the largest below which nothing counts.
inline constexpr double kHopeless = 7;

/// Relative error of a formula, one standard deviation: no catalogue describes a gyro exactly.
inline constexpr double kInexact = 0.05;

/// Logarithms without something else and with it. A formula's error is no something else: beside
/// an effect the smooth functions have its size times kInexact.
using Beside = std::array<double, 2>;
/// Adds likelihoods.
void add(const Beside& likely, Beside& sum);
/// Of each shape of all effects.
using Evidence = std::vector<Beside>;
inline constexpr Beside kNoLikelihood{-HUGE_VAL, -HUGE_VAL};

/// Likelihood of the drift, the level of the white noise integrated out, and averages over sizes of
/// what may be missing. A size is the rms of an effect in units of a row's white noise: from hardly
/// seen to what the drift has, equally probable beforehand on a logarithmic scale.
class Likelihood {
 public:
  explicit Likelihood(const Rivals& rivals);

  const std::vector<double>& sizes() const { return sizes_; }
  /// Sizes of the smooth functions: none, and every second of these.
  const std::vector<double>& smooth_sizes() const { return smooth_sizes_; }
  /// Probability beforehand of a size of the smooth functions, by its number, beside effects of
  /// which the largest has this size; 0: no effect.
  Beside log_prior(std::size_t smooth, double largest) const;
  /// Inverse of the largest variance of a coefficient.
  double least_precision() const { return 1 / (sizes_.back() * sizes_.back()); }

  /// Logarithm, but for a constant: of determinants and priors, and the square that is left.
  double operator()(double log_density, double left) const;
  /// What has to be left for a likelihood of `log_likelihood`.
  double left_for(double log_density, double log_likelihood) const;
  /// Of columns more, averaged over their sizes: their products among themselves, and with what a
  /// setting leaves. `largest`: size of effects that are there already.
  Beside averaged(const Setting& setting, double log_density, double left, double largest,
                  const Eigen::MatrixXd& own, const Eigen::VectorXd& with_drift) const;
  /// Of columns more where smooth functions are no matter.
  double averaged(double log_density, double left, const Eigen::MatrixXd& own,
                  const Eigen::VectorXd& with_drift) const;

 private:
  double of_size(double size, double log_density, double left, const Eigen::MatrixXd& own,
                 const Eigen::VectorXd& with_drift) const;

  double freedom_;
  std::vector<double> sizes_;
  std::vector<double> smooth_sizes_;
  double log_formulas_ = 0;  // probability beforehand that only formulas are off
  double log_smooth_ = 0;    // and that something else is missing, of one size
};

}  // namespace fogcomp::judge
