#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Sets the reference values of `terms` that were not given from the rows (fog::NotGiven), within
/// the catalogue's bounds. Afterwards they count as given: later fits to other rows keep them, so
/// that the coefficients keep their meaning. Bounds a place that is searched for
/// (fog::Scale::place) to the temperatures of the rows.
void set_references(std::vector<model::EffectTerm>& terms, const series::SignalSeries& series);

}  // namespace fogcomp::fit
