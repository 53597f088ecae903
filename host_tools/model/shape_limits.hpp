#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::model {

/// Sentences on shape parameters that the data determine too little: identified ones that ended at
/// a bound of their search, beyond which the data might fit better and a simpler effect may apply;
/// and those whose standard deviation spans their bounds. "`aging`: t0 is at its upper bound 2e+06
/// s: a line in time would do as well".
std::vector<std::string> shape_doubts(const EffectTerm& term);

/// Whether a place of the effect (fog::Scale::place) ended at a bound: the recordings do not pass
/// it, and what they see of the effect could be the tail of many others.
bool only_tail_is_seen(const EffectTerm& term);

/// Warning about a term without a coefficient above its standard deviation; "" if it has one.
std::string coefficient_doubt(const EffectTerm& term);

}  // namespace fogcomp::model
