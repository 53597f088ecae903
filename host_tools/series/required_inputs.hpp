#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/block_series.hpp"

namespace fogcomp::series {

/// Throws InputError with file, column and effect if a recording lacks an input of a term. To be
/// called before a model is run over a recording: missing columns would be zeros.
void require_inputs(const std::vector<model::EffectTerm>& terms, const BlockSeries& series);
/// The same, including the network.
void require_inputs(const model::Model& model, const BlockSeries& series);

}  // namespace fogcomp::series
