#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::series {

/// A signal between two samples.
struct Edge {
  double value = 0;
  double slope = 0;  ///< per sample
};

/// A signal between two samples that are means over their periods, at the end of sample `i` of a
/// stretch without gaps; i = -1: at the beginning of the first. In a smooth movement from the cubic
/// with the four means around, whose error goes with the fourth power of the sample period. Beside
/// a corner (rules::kMaxUnevenness) from a straight line through two means on the side without it,
/// so that a corner within a sample does not round the edges beside it (essentially non-oscillatory
/// reconstruction: Harten et al., J. Comput. Phys. 71, 231, 1987). Exact for straight lines between
/// corners that are three samples apart. `stretch`: first sample, of `size` >= 1.
Edge edge_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i);

}  // namespace fogcomp::series
