#include "report/plots.hpp"

#include <algorithm>
#include <cmath>

#include "report/html.hpp"
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

using findings::Look;

// Size of the picture and position of the axes, pixels.
constexpr double kWidth = 680;
constexpr double kHeight = 240;
constexpr double kLeft = 66;
constexpr double kRight = 672;
constexpr double kTop = 8;
constexpr double kBottom = 200;

// Maps a quantity to pixels, linearly or logarithmically.
class Scale {
 public:
  Scale(bool logarithmic, double first_pixel, double last_pixel)
      : logarithmic_(logarithmic), first_(first_pixel), last_(last_pixel) {}

  bool can_show(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
  void include(double value) {
    if (!can_show(value)) return;
    min_ = std::min(min_, on_axis(value));
    max_ = std::max(max_, on_axis(value));
  }
  // Adds a share of the span at both ends; around a single value a tenth of it, or 1.
  void widen(double share) {
    if (!(min_ <= max_)) min_ = max_ = 0;
    const double spare = max_ > min_ ? share * (max_ - min_) : std::max(0.1 * std::fabs(max_), 1.0);
    min_ -= spare;
    max_ += spare;
  }
  double pixel(double value) const {
    return first_ + (on_axis(value) - min_) / (max_ - min_) * (last_ - first_);
  }
  bool shows(double value) const {
    return can_show(value) && on_axis(value) >= min_ && on_axis(value) <= max_;
  }
  std::vector<double> ticks() const;

 private:
  double on_axis(double value) const { return logarithmic_ ? std::log10(value) : value; }

  bool logarithmic_;
  double first_;
  double last_;
  double min_ = HUGE_VAL;
  double max_ = -HUGE_VAL;
};

// At steps of 1, 2 or 5 times a power of ten; on a logarithmic axis at whole powers of ten.
std::vector<double> Scale::ticks() const {
  constexpr double kIntervals = 6;
  const double min_step = (max_ - min_) / kIntervals;
  const double power = std::pow(10, std::floor(std::log10(min_step)));
  double step = std::max(1.0, std::ceil(min_step));
  if (!logarithmic_) {
    step = min_step <= power ? power : min_step <= 2 * power ? 2 * power : 5 * power;
    if (min_step > step) step = 10 * power;
  }
  std::vector<double> ticks;
  for (double at = std::ceil(min_ / step); at * step <= max_; ++at) {
    ticks.push_back(logarithmic_ ? std::pow(10, at * step) : at * step);
  }
  return ticks;
}

struct Axes {
  Scale x;
  Scale y;
};

const std::vector<double>& x_of(const Plot& plot, const Curve& curve) {
  return curve.x.empty() ? plot.x : curve.x;
}

Axes axes_of(const Plot& plot) {
  const bool log_y = plot.kind == Plot::Kind::log_log;
  Axes axes{{log_y || plot.kind == Plot::Kind::log_x, kLeft, kRight}, {log_y, kBottom, kTop}};
  for (const Curve& curve : plot.curves) {
    for (const double x : x_of(plot, curve)) axes.x.include(x);
    for (const double y : curve.y) axes.y.include(y);
    for (std::size_t i = 0; i < curve.sigma.size() && !log_y; ++i) {
      axes.y.include(curve.y[i] - curve.sigma[i]);
      axes.y.include(curve.y[i] + curve.sigma[i]);
    }
  }
  for (const findings::Level& level : plot.levels) axes.y.include(level.y);
  axes.x.widen(0);
  axes.y.widen(0.06);
  return axes;
}

std::string line(double x1, double y1, double x2, double y2, const char* colour,
                 const char* more = "") {
  return format("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"var(--%s)\"%s/>", x1, y1, x2, y2, colour,
                more);
}

std::string label(double x, double y, const char* anchor, const findings::Text& text,
                  const char* more = "") {
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>%s</text>", x, y, anchor, more,
                escaped(text).c_str());
}

findings::Text tick_text(double at) {
  return findings::words(format("%.4g", at + 0.0));  // no -0
}

std::string bands_of(const Plot& plot, const Axes& axes) {
  std::string svg;
  for (const findings::Band& band : plot.bands) {
    if (band.colour.empty()) continue;
    const double left = std::clamp(axes.x.pixel(band.from), kLeft, kRight);
    const double right = std::clamp(axes.x.pixel(band.to), kLeft, kRight);
    svg += format(
        "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"var(--%s)\" "
        "opacity=\"0.13\"/>",
        left, kTop, right - left, kBottom - kTop, band.colour.c_str());
  }
  return svg;
}

std::string grid_of(const Plot& plot, const Axes& axes) {
  std::string svg;
  for (const double at : axes.x.ticks()) {
    const double x = axes.x.pixel(at);
    svg += line(x, kTop, x, kBottom, "rule") + label(x, kBottom + 15, "middle", tick_text(at));
  }
  for (const double at : axes.y.ticks()) {
    const double y = axes.y.pixel(at);
    svg += line(kLeft, y, kRight, y, "rule") + label(kLeft - 6, y + 4, "end", tick_text(at));
  }
  svg += label((kLeft + kRight) / 2, kBottom + 33, "middle", plot.x_label);
  return svg +
         label(
             0, 0, "middle", plot.y_label,
             format(" transform=\"translate(12 %.0f) rotate(-90)\"", (kTop + kBottom) / 2).c_str());
}

// A path through the minimum and maximum in each pixel column, broken at gaps.
std::string outline(const std::vector<double>& x, const std::vector<double>& y, const Axes& axes) {
  std::string path;
  bool begins = true;
  for (std::size_t i = 0; i < y.size();) {
    if (!axes.x.can_show(x[i]) || !axes.y.can_show(y[i])) {
      begins = true;
      ++i;
      continue;
    }
    const double pixel = std::floor(axes.x.pixel(x[i]));
    double min = y[i];
    double max = y[i];
    for (; i < y.size() && axes.x.can_show(x[i]) && axes.y.can_show(y[i]) &&
           std::floor(axes.x.pixel(x[i])) == pixel;
         ++i) {
      min = std::min(min, y[i]);
      max = std::max(max, y[i]);
    }
    path += format("%c%.0f %.1f", begins ? 'M' : 'L', pixel, axes.y.pixel(min));
    if (max > min) path += format("V%.1f", axes.y.pixel(max));
    begins = false;
  }
  return path;
}

std::string dots(const std::vector<double>& x, const std::vector<double>& y, const Axes& axes) {
  std::string path;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!axes.x.can_show(x[i]) || !axes.y.can_show(y[i])) continue;
    path += format("M%.0f %.0fh0", axes.x.pixel(x[i]), axes.y.pixel(y[i]));
  }
  return path;
}

std::string sigmas_of(const Plot& plot, const Curve& curve, const Axes& axes) {
  std::string path;
  const std::vector<double>& x = x_of(plot, curve);
  for (std::size_t i = 0; i < curve.sigma.size(); ++i) {
    const double low = curve.y[i] - curve.sigma[i];
    const double high = curve.y[i] + curve.sigma[i];
    if (!axes.x.can_show(x[i]) || !axes.y.shows(low) || !axes.y.shows(high)) continue;
    path += format("M%.0f %.1fV%.1f", axes.x.pixel(x[i]), axes.y.pixel(low), axes.y.pixel(high));
  }
  return path;
}

std::string curve_of(const Plot& plot, const Curve& curve, const Axes& axes) {
  const bool is_line = curve.look != Look::points && curve.look != Look::cloud;
  const std::vector<double>& x = x_of(plot, curve);
  const std::string path = is_line ? outline(x, curve.y, axes) : dots(x, curve.y, axes);
  const char* look = curve.look == Look::dashed   ? " stroke-dasharray=\"6 4\""
                     : curve.look == Look::faint  ? " opacity=\"0.6\""
                     : curve.look == Look::cloud  ? " stroke-width=\"2.5\" opacity=\"0.6\""
                     : curve.look == Look::points ? " stroke-width=\"6\""
                                                  : "";
  std::string svg =
      format("<path d=\"%s\" stroke=\"var(--%s)\"%s/>", path.c_str(), curve.colour.c_str(), look);
  const std::string sigmas = sigmas_of(plot, curve, axes);
  if (!sigmas.empty()) {
    svg += format("<path d=\"%s\" stroke=\"var(--%s)\"/>", sigmas.c_str(), curve.colour.c_str());
  }
  return svg;
}

std::string legend_of(const Plot& plot) {
  std::string html = "<p>";
  for (const Curve& curve : plot.curves) {
    html += "<span class=\"keyed\"><span class=\"key\" style=\"background:var(--" + curve.colour +
            ")\"></span> " + escaped(curve.label) + "</span> ";
  }
  return html + "</p>";
}

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

std::string plot_svg(const Plot& plot) {
  const Axes axes = axes_of(plot);
  std::string svg = format("<svg class=\"still\" viewBox=\"0 0 %.0f %.0f\">", kWidth, kHeight);
  svg += bands_of(plot, axes) + grid_of(plot, axes);
  for (const findings::Level& level : plot.levels) {
    const double y = axes.y.pixel(level.y);
    svg += line(kLeft, y, kRight, y, "mark", " stroke-dasharray=\"2 3\"") +
           label(kRight - 4, y - 4, "end", level.label);
  }
  for (const Curve& curve : plot.curves) svg += curve_of(plot, curve, axes);
  return svg + "</svg>\n" + legend_of(plot) + "\n";
}

}  // namespace fogcomp::report
