#include "report/plot.hpp"

#include <algorithm>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp::report {
namespace {

std::vector<double> rounded(std::vector<double> values, bool logarithmic) {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  for (double& value : values) {
    if (!std::isfinite(value) || value == 0) continue;
    const double span = logarithmic || most == least ? std::fabs(value) : most - least;
    const double unit = std::pow(10, 5 - std::floor(std::log10(span)));
    value = std::round(value * unit) / unit;
  }
  return values;
}

const char* name_of(Look look) {
  switch (look) {
    case Look::line:
      return "line";
    case Look::dashed:
      return "dashed";
    case Look::points:
      return "points";
    case Look::cloud:
      break;
  }
  return "cloud";
}

const char* name_of(Plot::Kind kind) {
  if (kind == Plot::Kind::linear) return "linear";
  return kind == Plot::Kind::log_log ? "log_log" : "stacked";
}

}  // namespace

Json plot_json(const Plot& plot) {
  const bool logarithmic = plot.kind == Plot::Kind::log_log;
  Json curves = Json::array();
  for (const Curve& curve : plot.curves) {
    Json one = Json::object();
    one.set("label", curve.label).set("colour", curve.colour).set("look", name_of(curve.look));
    one.set("y", rounded(curve.y, logarithmic));
    if (!curve.x.empty()) one.set("x", rounded(curve.x, logarithmic));
    if (!curve.sigma.empty()) one.set("sigma", rounded(curve.sigma, true));
    curves.push(std::move(one));
  }
  Json levels = json_array(plot.levels, [&](const Level& level) {
    return Json::object().set("label", level.label).set("y", level.y);
  });
  Json json = Json::object();
  json.set("kind", name_of(plot.kind)).set("group", plot.group);
  json.set("x_label", plot.x_label).set("y_label", plot.y_label);
  json.set("x", rounded(plot.x, logarithmic)).set("curves", std::move(curves));
  json.set("levels", std::move(levels));
  return json;
}

}  // namespace fogcomp::report
