#pragma once

#include <string>

#include "findings/plot.hpp"

namespace fogcomp::report {

/// A plot as it stands, with its legend, as HTML: for whoever reads a page where no script runs.
/// Of a curve the minimum and maximum of each pixel.
std::string plot_svg(const findings::Plot& plot);

}  // namespace fogcomp::report
