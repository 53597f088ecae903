#pragma once

#include <Eigen/Core>

#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Fast structure: the strongest line and the strongest octave of the residual's periodogram.
struct FastStructure {
  double line_period_s = 0;
  double line_power = 0;     ///< over that of its neighbours: exponentially distributed, mean 1
  double line_log_p = 0;     ///< logarithm of the chance that any line of white noise is as strong
  double band_period_s = 0;  ///< middle of the octave
  double band_excess = 0;    ///< of the octave's power above white noise, relative
  double band_log_p = 0;     ///< the same for any octave
  // Fractions of the residual's sum of squares: in the line, in the excess of the octave.
  double line_share = 0;
  double band_share = 0;
};

/// Analyses a whitened residual, run by run, for periods from two rows to a third of the run
/// (lines) or a twentieth (octaves).
FastStructure find_fast_structure(const series::Rows& rows,
                                  const Eigen::VectorXd& whitened_residual);

}  // namespace fogcomp::diagnosis
