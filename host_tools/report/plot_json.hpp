#pragma once

#include <vector>

#include "findings/plot.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// What the page's scripts shade and name along an axis.
Json bands_json(const std::vector<findings::Band>& bands);

/// What page/plots.js reads. Values are rounded to 1e-5 of their span (log_log: five digits), far
/// below a pixel.
Json plot_json(const findings::Plot& plot);

}  // namespace fogcomp::report
