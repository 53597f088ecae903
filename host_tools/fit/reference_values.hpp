#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Takes the references of `terms` that were not given from the rows (fog::NotGiven), within the
/// catalogue's bounds. From then on they count as given: a later fit to other rows keeps them, so
/// that its coefficients mean the same.
void set_references(std::vector<model::EffectTerm>& terms, const series::SignalSeries& series);

}  // namespace fogcomp::fit
