#pragma once

#include "model/model.hpp"

namespace fogcomp::model {

/// The term with coefficients as in the catalogue's example, deg/h; its shape stays. A coefficient
/// that the example lacks, of a higher order or a second part, is as large as the one before it.
/// Requires an effect of the catalogue.
EffectTerm of_typical_size(EffectTerm term);

}  // namespace fogcomp::model
