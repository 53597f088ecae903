#pragma once

#include <cstdint>
#include <vector>

namespace fogcomp::compare {

enum class Branch : std::uint8_t { heating, cooling, none };

/// The branch of each row, degC: the direction in which the temperature last moved by more than 2 %
/// of its range (at least 0.5 degC). Soaks count with the ramp before them; before the first
/// movement a row is on neither.
std::vector<Branch> branches(const std::vector<double>& temperature_degc);

}  // namespace fogcomp::compare
