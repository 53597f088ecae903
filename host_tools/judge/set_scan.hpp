#pragma once

#include <Eigen/Core>
#include <vector>

#include "judge/at_noise.hpp"
#include "judge/likelihood.hpp"
#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// A set of effects with given shapes in one setting of the noise: how likely it is with one effect
/// more, all sizes averaged.
class SetScan {
 public:
  /// `products`: of the set's columns with all columns of effects, weighted by the noise. All must
  /// outlive this.
  SetScan(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
          const std::vector<Place>& places, const Eigen::MatrixXd& products);

  /// Adds the logarithm of the likelihood with each shape more to `of_shapes`, where it may exceed
  /// `floor`.
  void add(double floor, Evidence& of_shapes) const;

 private:
  // Sizes of the set's effects.
  struct Sizes {
    Eigen::VectorXd precision;  // inverse of each coefficient's variance
    double largest = 0;
    double log_determinant = 0;  // of the variances
    double log_likelihood = 0;   // of the set
  };
  // What the set leaves.
  struct Rest {
    double log_density = 0;
    double left = 0;
    Eigen::VectorXd with_drift;
    Eigen::MatrixXd in_effects;  // of the set's directions, orthonormal, with all columns
    Eigen::ArrayXd gain;         // of each column, of any size
  };

  std::vector<Sizes> all_sizes() const;
  Rest without(const Eigen::VectorXd& precision, double log_determinant) const;
  static double gain_of(const Rest& rest, const Place& place);
  bool reaches(double floor) const;
  void add_at(const Sizes& sizes, double floor, Evidence& of_shapes) const;

  const Rivals& rivals_;
  const Likelihood& likelihood_;
  const Setting& setting_;
  const std::vector<Place>& places_;
  Eigen::MatrixXd cross_;       // set's columns x all
  Eigen::MatrixXd own_;         // set's columns
  Eigen::VectorXd with_drift_;  // set's columns
};

}  // namespace fogcomp::judge
