#pragma once

#include <vector>

#include "judge/set_search.hpp"

namespace fogcomp::judge {

/// For each effect the size from which on the rows would have shown it, deg/h rms over the rows:
/// one of this size is as probable as none, so that it is found in half of all cases. Of its
/// shapes, half are seen from this size on. `left`: squares that are noise, in each noise of
/// `search`.
std::vector<double> visible_from_dph(const Rivals& rivals, const FoundSets& search,
                                     const std::vector<double>& left);

}  // namespace fogcomp::judge
