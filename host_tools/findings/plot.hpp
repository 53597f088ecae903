#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "findings/text.hpp"

namespace fogcomp::findings {

/// How a curve is drawn.
enum class Look : std::uint8_t {
  line,
  dashed,
  faint,  ///< a line behind what matters
  points,
  cloud,  ///< small faint points, of which there are hundreds
};

struct Curve {
  Text label;
  std::string colour;           ///< measured, model, residual, second, mark, part1...
  std::vector<double> y;        ///< in the plot's unit; not finite: a gap
  std::vector<double> x{};      ///< of its own, in any order; empty: the plot's
  std::vector<double> sigma{};  ///< standard deviations to draw as bars; empty: none
  Look look = Look::line;
};

/// A line across the whole plot, such as a noise floor.
struct Level {
  Text label;
  double y = 0;
};

/// A part of the x axis with a name, such as a soak or a ramp; shaded behind the curves.
struct Band {
  Text label;
  double from = 0;  ///< in the plot's unit
  double to = 0;
  std::string colour{};  ///< as Curve::colour; "": not shaded, only named
};

/// A plot as data.
struct Plot {
  enum class Kind : std::uint8_t {
    linear,
    log_x,  ///< y linear
    log_log,
    stacked
  };
  Text title;
  Text x_label;  ///< with the unit, as "time, h"
  Text y_label;
  std::vector<Curve> curves;  ///< later ones lie on top
  std::vector<double> x{};    ///< rising; of all curves that have none of their own
  std::vector<Text> names{};  ///< of what lies at each x, told where a reader points; or none
  std::vector<Level> levels{};
  std::vector<Band> bands{};
  Text caption{};       ///< what is to be seen
  std::string group{};  ///< plots of one group share cursor and zoom in x
  Kind kind = Kind::linear;
  bool is_small = false;  ///< two stand side by side where there is room
};

}  // namespace fogcomp::findings
