#pragma once

#include <Eigen/Core>
#include <vector>

#include "judge/at_noise.hpp"
#include "judge/likelihood.hpp"
#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// Adds to `of_shapes` how likely a set of effects with given shapes is with each shape more, in
/// one setting of the noise, all sizes averaged, where the logarithm may exceed `floor`.
/// `products`: of the set's columns with all columns of effects, weighted by the noise, without the
/// model.
void scan_set(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
              const std::vector<Part>& parts, const Eigen::MatrixXd& products, double floor,
              Evidence& of_shapes);

}  // namespace fogcomp::judge
