#include "report/plot_json.hpp"

#include <algorithm>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp::report {
namespace {

using findings::Band;
using findings::Curve;
using findings::Level;
using findings::Plot;
using findings::Text;

std::vector<double> rounded_for_axis(std::vector<double> values, bool logarithmic) {
  double min = HUGE_VAL;
  double max = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    min = std::min(min, value);
    max = std::max(max, value);
  }
  for (double& value : values) {
    if (!std::isfinite(value) || value == 0) continue;
    const double span = logarithmic || max == min ? std::fabs(value) : max - min;
    const double unit = std::pow(10, 5 - std::floor(std::log10(span)));
    value = std::round(value * unit) / unit;
  }
  return values;
}

// In the order of Look and of Plot::Kind; page/plots.js knows them by these names.
constexpr const char* kLooks[] = {"line", "dashed", "faint", "points", "cloud"};
constexpr const char* kKinds[] = {"linear", "log_x", "log_log", "stacked"};

}  // namespace

Json bands_json(const std::vector<Band>& bands) {
  return json_array(bands, [](const Band& band) {
    return Json::object()
        .set("label", band.label.typeset())
        .set("from", band.from)
        .set("to", band.to)
        .set("colour", band.colour);
  });
}

Json plot_json(const Plot& plot) {
  const bool log_y = plot.kind == Plot::Kind::log_log;
  const bool log_x = log_y || plot.kind == Plot::Kind::log_x;
  Json curves = Json::array();
  for (const Curve& curve : plot.curves) {
    Json one = Json::object();
    one.set("label", curve.label.typeset()).set("colour", curve.colour);
    one.set("look", kLooks[static_cast<std::size_t>(curve.look)])
        .set("y", rounded_for_axis(curve.y, log_y));
    if (!curve.x.empty()) one.set("x", rounded_for_axis(curve.x, log_x));
    if (!curve.sigma.empty()) one.set("sigma", rounded_for_axis(curve.sigma, true));
    curves.push(std::move(one));
  }
  Json levels = json_array(plot.levels, [&](const Level& level) {
    return Json::object().set("label", level.label.typeset()).set("y", level.y);
  });
  Json names = json_array(plot.names, [](const Text& name) { return Json(name.typeset()); });
  Json json = Json::object();
  json.set("kind", kKinds[static_cast<std::size_t>(plot.kind)]).set("group", plot.group);
  json.set("x_label", plot.x_label.typeset()).set("y_label", plot.y_label.typeset());
  json.set("x", rounded_for_axis(plot.x, log_x)).set("names", std::move(names));
  json.set("curves", std::move(curves)).set("levels", std::move(levels));
  json.set("bands", bands_json(plot.bands));
  return json;
}

}  // namespace fogcomp::report
