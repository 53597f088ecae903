#pragma once

#include <string>
#include <vector>

#include "findings/plot.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// Bands along the x axis, which page/drawing.js shades and names: label, from, to, colour.
Json bands_json(const std::vector<findings::Band>& bands);

/// A plot as page/plots.js reads it. Values are rounded to 1e-5 of their span (on logarithmic axes
/// to five digits), far below a pixel.
Json plot_json(const findings::Plot& plot);

/// A static SVG of a plot with its legend, for readers without scripts. A curve is drawn by its
/// minimum and maximum in each pixel column.
std::string plot_svg(const findings::Plot& plot);

}  // namespace fogcomp::report
