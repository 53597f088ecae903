#pragma once

#include <cstdint>
#include <vector>

namespace fogcomp::compare {

enum class Branch : std::uint8_t { heating, cooling, none };

/// The branch of each row: direction in which the temperature last moved by more than 2 % of its
/// range (at least 0.5 degC). A soak belongs to the branch of the ramp before it; before the first
/// movement a row has none.
std::vector<Branch> branches(const std::vector<double>& temperature_degc);

}  // namespace fogcomp::compare
