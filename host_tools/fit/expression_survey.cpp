#include "fit/expression_survey.hpp"

#include <algorithm>
#include <cmath>

#include "core/thermal/filtered_derivative.hpp"
#include "fit/decision_rules.hpp"
#include "model/shape_parameter.hpp"
#include "support/input_error.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kHour = 3600;  // s; a whole number of blocks

model::SignalRange widened(fog::Input input, const model::SignalRange& seen) {
  switch (input) {
    case fog::Input::temperature_rate:
      return {-fog::kMaxRateDegcPerMin, fog::kMaxRateDegcPerMin};
    case fog::Input::elapsed:
      return {0, kHour * std::ceil(rules::kTimeWidening * seen.max / kHour)};
    default:
      break;
  }
  const double size = std::max(std::abs(seen.min), std::abs(seen.max));
  const double more = rules::kSignalWidening * std::max(seen.max - seen.min, size);
  return {seen.min - more, seen.max + more};
}

// `may_be_zero`: another shape may be not.
void check(const model::EffectTerm& term, const Eigen::VectorXd& column, bool may_be_zero) {
  if (!column.allFinite()) {
    throw InputError("expression '" + term.name + "'",
                     "is not finite over these recordings; does it divide by 0, or take a power of "
                     "a negative value?");
  }
  if (!may_be_zero && column.cwiseAbs().maxCoeff() == 0) {
    throw InputError("expression '" + term.name + "'",
                     "is 0 all the time on these recordings; leave it out");
  }
}

}  // namespace

void set_expression_ranges(std::vector<model::EffectTerm>& terms,
                           const series::SignalSeries& series) {
  const bool any = std::any_of(terms.begin(), terms.end(), [](const model::EffectTerm& term) {
    return term.expression.has_value();
  });
  if (!any) return;
  const model::SignalRanges seen = series.signal_ranges();
  for (model::EffectTerm& term : terms) {
    if (!term.expression) continue;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      term.expression->ranges[i] = widened(static_cast<fog::Input>(i), seen[i]);
    }
    term.expression->scale_log2 = 0;
    check(term, series.regressors(term), !model::shape_parameters({term}).empty());
  }
}

int set_expression_scale(model::EffectTerm& term, const series::SignalSeries& series) {
  if (!term.expression) return 0;
  const Eigen::VectorXd column = series.regressors(term);
  check(term, column, false);
  const int scale_log2 = term.expression->scale_log2 + std::ilogb(column.cwiseAbs().maxCoeff());
  const int risen = scale_log2 - term.expression->scale_log2;
  term.expression->scale_log2 = scale_log2;
  const auto rescale = [&](std::vector<model::Estimate>& coefficients_dph) {
    for (model::Estimate& coefficient : coefficients_dph)
      coefficient = {std::ldexp(coefficient.value, risen), std::ldexp(coefficient.sigma, risen)};
  };
  rescale(term.coefficients_dph);
  if (term.gyro) rescale(term.gyro->coefficients_dph);
  return risen;
}

}  // namespace fogcomp::fit
