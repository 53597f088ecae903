#pragma once

#include <Eigen/Core>

#include "simulation/coil/coil_geometry.hpp"

namespace fogcomp::simulation {

/// One number per cell of the pack: row = layer from the inside, column = axial cell from the
/// bottom.
using CellArray = Eigen::ArrayXXd;

/// Where the fibre lies: for every cell the integral of (L - 2z) dz over the fibre in it, in m^2,
/// with z the distance along the fibre and L its length. Each turn is placed in its layer and at
/// its height, at its true distance from the midpoint; a half that fills a layer from the bottom
/// fills its next one from the top.
///
/// The sum over all cells is zero: no winding turns a uniform temperature rate into a rate error.
/// Signs are such that a coil warmed from outside errs in the positive sense.
CellArray winding_weights(const CoilGeometry& coil, int axial_cells);

}  // namespace fogcomp::simulation
