#pragma once

#include "findings/plot.hpp"
#include "support/json.hpp"

namespace fogcomp::report {

/// What page/plots.js reads. Values are rounded to 1e-5 of their span (log_log: five digits), far
/// below a pixel.
Json plot_json(const findings::Plot& plot);

}  // namespace fogcomp::report
