#pragma once

#include <string>
#include <vector>

#include "fit/identify.hpp"

namespace fogcomp::fit {

/// An unknown before a fit with a prior and after it, in the catalogue's unit.
struct PriorUpdate {
  std::string name;
  std::string unit;
  model::Estimate before;
  model::Estimate after;
  Departure departure;

  /// Share of what was known before in what is known now, 0..1.
  double from_before() const;
};

/// Of each unknown of a model that was fitted with a prior.
std::vector<PriorUpdate> prior_updates(const model::Model& model, const Identification& identified);

}  // namespace fogcomp::fit
