#pragma once

#include <string>

#include "fit/fit_model.hpp"

namespace fogcomp::findings {

/// Whether a network was judged worth keeping, in a line; "" where none was judged.
std::string network_verdict(const fit::FitResult& fit);

}  // namespace fogcomp::findings
