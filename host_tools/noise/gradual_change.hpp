#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "noise/whitening.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// How much more a change that takes one to eight minutes explains than a jump before `row`, within
/// eight minutes of it and beside a curve: the further decrease of the sum of squares, in units of
/// what is left there; 0 if no more. The two rows next to the jump, one of which it divides, do not
/// count. `whitened_residual`: one value per row, with the jump in it.
double gain_of_gradual_change(std::size_t row, const Whitening& whitening, const series::Rows& rows,
                              const Eigen::VectorXd& whitened_residual);

}  // namespace fogcomp::noise
