#pragma once

#include <string>

#include "findings/plot.hpp"

namespace fogcomp::report {

/// A static SVG of a plot with its legend, for readers without scripts. A curve is drawn by its
/// minimum and maximum in each pixel column.
std::string plot_svg(const findings::Plot& plot);

}  // namespace fogcomp::report
