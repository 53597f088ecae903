#pragma once

#include <string>
#include <vector>

#include "model/network.hpp"

namespace fogcomp::network {

/// `temperature,temperature_rate,lagged_temperature:tau=300` -> inputs without normalisation. Up to
/// four; lagged temperatures with different time constants are allowed. Throws InputError for an
/// unknown or missing part.
std::vector<model::RealInput> parse_network_inputs(const std::string& list);

}  // namespace fogcomp::network
