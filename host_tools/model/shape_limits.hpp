#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::model {

/// The catalogue's words for what an effect of time alone becomes at its slowest shape.
inline constexpr const char* kLineInTime = "a line in time";

/// A shape parameter that the data determine too little.
struct ShapeDoubt {
  std::size_t parameter = 0;
  std::string sentence;   ///< e.g. "`aging`: t0 is at its upper bound 2e+06 s: a line in time ..."
  std::string instead{};  ///< simpler form that would do as well, e.g. kLineInTime; "": none
  bool wants_more = false;  ///< at its upper bound, and no simpler form would do
};

/// Identified parameters that ended at a bound of their search, beyond which the data might fit
/// better and a simpler effect may apply; and those whose standard deviation spans their bounds.
std::vector<ShapeDoubt> shape_doubts(const EffectTerm& term);

/// Whether a place of the effect (fog::Scale::place) ended at a bound: the recordings do not pass
/// it, and what they see of the effect could be the tail of many others.
bool only_tail_is_seen(const EffectTerm& term);

/// Warning about a term without a coefficient above its standard deviation; "" if it has one.
std::string coefficient_doubt(const EffectTerm& term);

}  // namespace fogcomp::model
