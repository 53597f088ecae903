#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "findings/text.hpp"

namespace fogcomp::findings {

/// Style of a curve.
enum class Look : std::uint8_t {
  line,
  dashed,
  faint,  ///< a line in the background
  points,
  cloud,  ///< hundreds of small faint points
};

struct Curve {
  Text label;
  std::string colour;           ///< measured, model, residual, second, mark, part1...
  std::vector<double> y;        ///< in the plot's unit; not finite: a gap
  std::vector<double> x{};      ///< its own, in any order; empty: the plot's
  std::vector<double> sigma{};  ///< standard deviations, drawn as error bars; empty: none
  Look look = Look::line;
};

/// A horizontal line, such as a noise floor.
struct Level {
  Text label;
  double y = 0;
};

/// A named part of the x axis, such as a soak or a ramp; shaded behind the curves.
struct Band {
  Text label;
  double from = 0;  ///< in the plot's unit
  double to = 0;
  std::string colour{};  ///< as Curve::colour; "": only named, not shaded
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
  std::vector<Curve> curves;  ///< later ones on top
  std::vector<double> x{};    ///< rising; for all curves without their own
  std::vector<Text> names{};  ///< of the points at each x, shown at the pointer; or none
  std::vector<Level> levels{};
  std::vector<Band> bands{};
  Text caption{};       ///< what the plot shows
  std::string group{};  ///< plots of a group share cursor and zoom in x
  Kind kind = Kind::linear;
  bool is_small = false;  ///< two are placed side by side if possible
};

}  // namespace fogcomp::findings
