#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::recording {

/// Whether values make up for each other: sums of `window` neighbours scatter far less
/// (rules::kMaxBalancedScatter) than those of independent values, whose variance grows with their
/// number. So do spacings of samples that arrive late, and not those of samples that are lost.
/// False with fewer than rules::kMinWindows sums.
bool are_balanced(const std::vector<double>& values, std::size_t window);

}  // namespace fogcomp::recording
