#include "fit/reference_values.hpp"

#include <algorithm>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "support/units.hpp"

namespace fogcomp::fit {
namespace {

// With this reference an error proportional to W (T - reference) has no part proportional to W.
// Without any input rate: the plain mean.
double mean_temperature_degc(const series::Rows& rows) {
  double weights = 0;
  double sum = 0;
  double plain = 0;
  for (const auto& means : rows.inputs) {
    const double weight = std::pow(means.input_rate, 2);
    weights += weight;
    sum += weight * means.temperature;
    plain += means.temperature;
  }
  return weights > 0 ? sum / weights : plain / static_cast<double>(rows.inputs.size());
}

double largest_input_rate_dps(const series::SignalSeries& series) {
  const auto range = series.signal_ranges()[static_cast<std::size_t>(fog::Input::input_rate)];
  return std::max(std::abs(range.min), std::abs(range.max)) / kDphPerDegreePerSecond;
}

// Beyond the recorded temperatures only a tail of the effect is seen, which could be of many
// others. A place that was found beyond them, on other recordings, is left alone.
void bound_places(model::EffectTerm& term, const model::CatalogueEntry& entry,
                  const series::SignalSeries& series) {
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    model::Parameter& place = term.parameters[i];
    if (entry.parameters[i].scale != fog::Scale::place || !place.identified) continue;
    const model::SignalRange degc =
        series.signal_ranges()[static_cast<std::size_t>(fog::Input::temperature)];
    const model::ShapeBounds whole = model::catalogue_bounds(entry, i);
    const model::ShapeBounds seen{std::max(whole.min, degc.min), std::min(whole.max, degc.max)};
    const bool is_new = term.coefficients_dph.empty();
    const bool varies = seen.max - seen.min >= rules::kMinSpanOfPlaceDegc;
    if (!varies || !(is_new || (place.value >= seen.min && place.value <= seen.max))) continue;
    if (place.bounds.are_given()) continue;  // the user's
    place.bounds = seen;
    place.value = std::clamp(place.value, seen.min, seen.max);
  }
}

}  // namespace

void set_references(std::vector<model::EffectTerm>& terms, const series::SignalSeries& series) {
  for (model::EffectTerm& term : terms) {
    if (term.expression) continue;
    const model::CatalogueEntry& entry = model::find_effect(term.name);
    bound_places(term, entry, series);
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      if (!model::is_reference(entry.parameters[i]) || !term.parameters[i].identified) continue;
      const bool degc = entry.parameters[i].not_given == fog::NotGiven::mean_temperature;
      const double seen =
          degc ? mean_temperature_degc(series.rows()) : largest_input_rate_dps(series);
      const model::ShapeBounds bounds = model::catalogue_bounds(entry, i);
      term.parameters[i] = {std::clamp(seen, bounds.min, bounds.max)};
    }
  }
}

}  // namespace fogcomp::fit
