#pragma once

#include <vector>

#include "findings/document.hpp"
#include "research/gyros.hpp"

namespace fogcomp::findings {

/// The reference paper's figures 1, 3, 4, 8, 9, 10 and Tables 1 to 3 for the first gyro, with the
/// printed values, and medians over all gyros. Throws InputError if the study lacks bp or pso-bp.
Document paper_findings(const std::vector<research::Study>& studies);

}  // namespace fogcomp::findings
