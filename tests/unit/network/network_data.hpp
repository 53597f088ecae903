#pragma once

#include <cmath>

#include "network/network_training.hpp"
#include "network/trainer_parts.hpp"

namespace fog::test {

/// Rows of a smooth surface over two inputs within the unit square, with uniform noise.
inline fogcomp::network::NetworkTask smooth_task(Eigen::Index rows, double noise_dph,
                                                 std::uint64_t seed) {
  fogcomp::network::Uniform uniform(seed);
  fogcomp::network::NetworkTask task;
  task.inputs.resize(rows, 2);
  task.target_dph.resize(rows);
  task.weights.setOnes(rows);
  task.run_starts = {0};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double x = uniform.within(1);
    const double y = uniform.within(1);
    task.inputs.row(i) << x, y;
    task.target_dph[i] =
        0.5 * std::sin(3 * x) + 0.3 * x * y - 0.2 * y * y + uniform.within(noise_dph);
  }
  return task;
}

}  // namespace fog::test
