#pragma once

#include <string>

#include "fit/fit_model.hpp"

namespace fogcomp::findings {

/// Result of the comparison of a network with the effects alone, one line; "" without one.
std::string network_verdict(const fit::FitResult& fit);

}  // namespace fogcomp::findings
