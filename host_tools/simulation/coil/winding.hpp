#pragma once

#include <Eigen/Core>

#include "simulation/coil/coil_geometry.hpp"

namespace fogcomp::simulation {

/// One value per cell of the pack: row = layer from the inside, column = axial cell from the
/// bottom.
using CellArray = Eigen::ArrayXXd;

/// Weight of the fibre in every cell: integral of (L - 2z) dz over the fibre in it, in m^2, z being
/// the distance along the fibre and L its length. Each turn is placed in its layer and at its
/// height, at its true distance from the midpoint; a half that fills a layer from the bottom fills
/// its next layer from the top.
///
/// The sum over all cells is zero: a uniform temperature rate makes no rate error. With this sign a
/// coil warmed from outside has a positive error.
CellArray winding_weights(const CoilGeometry& coil, int axial_cells);

}  // namespace fogcomp::simulation
