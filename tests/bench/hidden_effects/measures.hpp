#pragma once

#include <vector>

#include "measure.hpp"

namespace fogcomp::bench {

/// All measures over those cases of the basic cycle that have an answer, and of the wide one.
std::vector<Measure> basic_measures(const std::vector<CaseResult>& results);
std::vector<Measure> wide_measures(const std::vector<CaseResult>& results);

}  // namespace fogcomp::bench
