#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::model {

/// A shape parameter of a term about which the data said too little.
struct ShapeDoubt {
  std::size_t parameter = 0;
  std::string sentence;  ///< e.g. "`aging`: t0 is at its upper bound 2e+06 s: a line in time ..."
};

/// Identified parameters that ended at a bound of their search, where the data would have gone on
/// and the effect may be another, simpler one; and those known no better than that they lie within
/// their bounds (one standard deviation spans them).
std::vector<ShapeDoubt> shape_doubts(const EffectTerm& term);

/// What is to be said of a term none of whose coefficients is larger than its standard deviation;
/// "" where one is.
std::string coefficient_doubt(const EffectTerm& term);

}  // namespace fogcomp::model
