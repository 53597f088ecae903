#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/block_series.hpp"

namespace fogcomp::series {

/// Throws InputError, naming file, column and effect, where a recording lacks what one of the terms
/// needs. Whoever leads a model through a recording asks first: a missing column would be zeros.
void require_inputs(const std::vector<model::EffectTerm>& terms, const BlockSeries& series);
/// What the network needs too.
void require_inputs(const model::Model& model, const BlockSeries& series);

}  // namespace fogcomp::series
