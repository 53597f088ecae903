#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/json.hpp"

namespace fogcomp::report {

/// How a curve is drawn.
enum class Look : std::uint8_t {
  line,
  dashed,
  points,
  cloud,  ///< small faint points, of which there are hundreds
};

struct Curve {
  std::string label;
  std::string colour;       ///< a name of page/style.css without "--": measured, model, part1...
  std::vector<double> y;    ///< in the plot's unit; not finite: a gap
  std::vector<double> x{};  ///< of its own, in any order; empty: the plot's
  std::vector<double> sigma{};  ///< standard deviations to draw as bars; empty: none
  Look look = Look::line;
};

/// A line across the whole plot, such as a noise floor.
struct Level {
  std::string label;
  double y = 0;
};

/// A plot as data; page/plots.js draws it.
struct Plot {
  enum class Kind : std::uint8_t { linear, log_log, stacked };
  std::string title;
  std::string x_label;  ///< with the unit, as "time, h"
  std::string y_label;
  std::vector<Curve> curves;
  std::vector<double> x{};  ///< rising; of all curves that have none of their own
  std::vector<Level> levels{};
  std::string caption{};  ///< what to look at, and how the rows were thinned
  std::string group{};    ///< plots of one group share cursor and zoom in x
  Kind kind = Kind::linear;
};

/// What page/plots.js reads. Values are rounded to 1e-5 of their span (log_log: five digits), far
/// below a pixel.
Json plot_json(const Plot& plot);

}  // namespace fogcomp::report
