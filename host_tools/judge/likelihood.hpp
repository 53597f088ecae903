#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// log(e^a + e^b).
double log_add(double a, double b);

/// Logarithm of a probability relative to the largest below which nothing counts.
inline constexpr double kHopeless = 7;

/// Relative error of a formula, one standard deviation: no catalogue describes a gyro exactly.
inline constexpr double kInexact = 0.05;

/// Without something else and with it. A formula's error is no something else: beside an effect the
/// smooth functions have its size times kInexact.
using Beside = std::array<double, 2>;

/// A sum of likelihoods, of which only the logarithms are of the size of numbers.
class Sum {
 public:
  /// Adds e^log_scale times these.
  void add(double log_scale, const Beside& factors);
  void add(const Sum& other) { add(other.log_scale_, other.factors_); }
  Beside log() const {
    return {log_scale_ + std::log(factors_[0]), log_scale_ + std::log(factors_[1])};
  }
  double log_total() const { return log_scale_ + std::log(factors_[0] + factors_[1]); }

 private:
  double log_scale_ = -HUGE_VAL;
  Beside factors_{0, 0};
};
/// Of each shape of all effects.
using Evidence = std::vector<Sum>;

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
  Beside prior(std::size_t smooth, double largest) const;
  /// Inverse of the largest variance of a coefficient.
  double least_precision() const { return 1 / (sizes_.back() * sizes_.back()); }

  /// Logarithm, but for a constant: of determinants and priors, and the square that is left.
  double operator()(double log_density, double left) const;
  /// What has to be left for a likelihood of `log_likelihood`.
  double left_for(double log_density, double log_likelihood) const;
  /// The same of each size of an effect more, all of which are equally probable.
  std::vector<Beside> priors_of_sizes(std::size_t smooth, double largest) const;
  /// Adds the likelihood of columns more, averaged over sizes with these priors. `own`,
  /// `with_drift`: their products among themselves, and with what is left.
  void add_average(const std::vector<Beside>& priors, double log_density, double left,
                   const Eigen::Ref<const Eigen::MatrixXd>& own,
                   const Eigen::Ref<const Eigen::VectorXd>& with_drift, Sum& sum) const;

 private:
  double freedom_;
  std::vector<double> sizes_;
  std::vector<double> smooth_sizes_;
  double something_else_ = 0;  // probability beforehand that it is missing, of one size
};

}  // namespace fogcomp::judge
