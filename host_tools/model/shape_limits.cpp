#include "model/shape_limits.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

constexpr double kAtBound = 1e-3;  // fraction of the range: ten difference steps of the search

std::string with_unit(const char* pattern, double value, const std::string& unit) {
  return format(pattern, value) + (unit.empty() ? "" : " " + unit);
}

std::string bound_words(const TermInfo::Parameter& parameter, bool upper, double value) {
  const char* const instead = upper ? parameter.at_most : parameter.at_least;
  return parameter.name + " is at its " + (upper ? "upper" : "lower") + " bound " +
         with_unit("%.5g", value, parameter.unit) + ": " +
         (instead == nullptr
              ? std::string("these data would have it ") + (upper ? "larger" : "smaller") + " still"
              : std::string(instead) + " would do as well");
}

bool is_at_bound(const ShapeParameter& shape, double value) {
  const double unit = shape.to_unit(value);
  return unit <= kAtBound || unit >= 1 - kAtBound;
}

}  // namespace

std::vector<std::string> shape_doubts(const EffectTerm& term) {
  std::vector<std::string> doubts;
  const TermInfo info = info_of(term);
  for (const ShapeParameter& shape : shape_parameters({term})) {
    const TermInfo::Parameter& parameter = info.parameters[shape.index];
    const double value = term.parameters[shape.index].value;
    const double sigma = term.parameters[shape.index].sigma;
    std::string words;
    if (is_at_bound(shape, value)) {
      words = bound_words(parameter, shape.to_unit(value) > 0.5, value);
    } else if (sigma >= std::abs(shape.slope(value))) {
      words = format("%s is not determined: %.5g +- %.2g", parameter.name.c_str(), value, sigma) +
              with_unit(", anywhere from %.5g", shape.min, "") +
              with_unit(" to %.5g", shape.max, parameter.unit);
    }
    if (!words.empty()) doubts.push_back("`" + term.name + "`: " + words);
  }
  return doubts;
}

bool only_tail_is_seen(const EffectTerm& term) {
  const std::vector<ShapeParameter> shapes = shape_parameters({term});
  return std::any_of(shapes.begin(), shapes.end(), [&](const ShapeParameter& shape) {
    return shape.scale == fog::Scale::place &&
           is_at_bound(shape, term.parameters[shape.index].value);
  });
}

std::string coefficient_doubt(const EffectTerm& term) {
  for (const Estimate& coefficient : term.coefficients_dph) {
    if (std::abs(coefficient.value) > coefficient.sigma) return "";
  }
  return "`" + term.name + "`: none of its coefficients is larger than its uncertainty";
}

}  // namespace fogcomp::model
