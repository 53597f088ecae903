#pragma once

#include <string>
#include <vector>

#include "model/network.hpp"

namespace fogcomp::fit {

/// `temperature,temperature_rate,lagged_temperature:tau=300` -> inputs without normalisation. Up to
/// four; a lagged temperature may stand there with several time constants. Throws InputError naming
/// what is unknown or missing.
std::vector<model::RealInput> parse_network_inputs(const std::string& list);

}  // namespace fogcomp::fit
