#include "fit/physical_lags.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/undetermined.hpp"
#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// Frees the shapes that are time constants of the temperature rate; false if there are none.
bool free_lags(std::vector<model::EffectTerm>& terms) {
  bool any = false;
  for (model::EffectTerm& term : terms) {
    const model::TermInfo info = model::info_of(term);
    for (std::size_t i = 0; i < term.parameters.size(); ++i) {
      bool& free = term.parameters[i].identified;
      free = free && info.parameters[i].time == fog::Time::constant_of_rate;
      any = any || free;
    }
  }
  return any;
}

}  // namespace

std::vector<PhysicalLag> physical_lags(const model::Model& model,
                                       const std::vector<runs::Run>& runs, bool run_offsets) {
  std::vector<PhysicalLag> lags;
  std::vector<model::EffectTerm> terms = model.terms;
  if (!free_lags(terms)) return lags;
  model::Model sharper = model;
  sharper.derivative_tau_s /= rules::kSharperDerivative;
  const series::SignalSeries series = runs::series_of(sharper, runs, series::Phase::zero);
  constexpr bool kShapesFound = true;  // the same minimum, not a better one elsewhere
  const NoiseWeightedFit fit =
      fit_rows(series, terms, run_offset_columns(series.rows(), run_offsets),
               {{}, std::nullopt, kShapesFound});
  if (!is_determined(fit)) return lags;
  const double widening = std::max(1.0, fit.birge_ratio());
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const model::ShapeParameter& shape = fit.shapes[i];
    const model::EffectTerm& term = fit.terms[shape.term];
    const double value_s = term.parameters[shape.index].value;
    const Eigen::Index at = fit.linear() + static_cast<Eigen::Index>(i);
    const double sigma = widening * std::sqrt(fit.covariance(at, at));
    lags.push_back({term.name, model::info_of(term).parameters[shape.index].name, value_s,
                    sigma * std::abs(shape.slope(value_s))});
  }
  return lags;
}

std::string physical_lag_words(const PhysicalLag& lag) {
  return format(
      "%-24s %s without the lags of the board's derivative, the gyro's own: %.4g +- %.2g s",
      lag.effect.c_str(), lag.parameter.c_str(), lag.value_s, lag.sigma_s);
}

}  // namespace fogcomp::fit
