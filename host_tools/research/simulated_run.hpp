#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::research {

/// One run of the simulated gyro `paper`, in rows of 10 s, with its true drift.
struct SimulatedRun {
  series::SignalSeries series;
  Eigen::VectorXd truth_dph;          ///< per row: the drift without any noise
  Eigen::MatrixXd effects_dph;        ///< rows x effects of the simulator; their sum is the truth
  double noise_floor_dph = 0;         ///< of a row, from the recording alone
  std::vector<std::string> segments;  ///< per row: its segment in the programme
};

/// Simulates preset `paper` through a built-in profile, sampled once a second like the board's
/// blocks. `settings` must outlive the result.
SimulatedRun simulate_run(const std::string& profile, std::uint64_t seed,
                          const model::Model& settings);

/// Error due to noise alone: expected rms error, deg/h, on the rows of `asked` of a fit to `fitted`
/// that knows the exact time course of every simulated effect and estimates only the sizes, with
/// weights by the true noise (Cramer-Rao bound of the sizes). A method that has to estimate more
/// has a larger error. Both runs are of one gyro.
double estimate_floor_dph(const SimulatedRun& fitted, const SimulatedRun& asked);

}  // namespace fogcomp::research
