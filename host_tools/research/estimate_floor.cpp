#include "research/estimate_floor.hpp"

#include <cmath>

#include "fit/noise_weighted_fit.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::research {

double estimate_floor_dph(const SimulatedRun& fitted, const SimulatedRun& asked) {
  const series::Rows& rows = fitted.series.rows();
  const noise::NoiseModel noise = noise::fit_noise(
      noise::noise_samples({rows.drift_dph - fitted.truth_dph}), rows.row_s, rows.longest_run_s());
  const noise::Whitening whitening(noise, rows, rows.weights);
  const LinearFit sizes =
      solve_linear(whitening.apply(fitted.effects_dph), whitening.apply(rows.drift_dph));
  const Eigen::MatrixXd& effects = asked.effects_dph;
  return std::sqrt((effects * sizes.covariance).cwiseProduct(effects).rowwise().sum().mean());
}

}  // namespace fogcomp::research
