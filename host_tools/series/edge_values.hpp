#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::series {

/// Value of a signal between two samples that are means over their periods, at the end of sample
/// `i` of a stretch without gaps; i = -1: at the beginning of the first. From a straight line
/// through two neighbouring means on whichever side the signal is straighter, so that a corner
/// within a sample does not round the edges beside it (essentially non-oscillatory reconstruction:
/// Harten et al., J. Comput. Phys. 71, 231, 1987). Exact for straight lines between corners that
/// are three samples apart. `stretch`: first sample, of `size` >= 1.
double value_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i);

}  // namespace fogcomp::series
