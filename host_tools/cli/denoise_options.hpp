#pragma once

#include <vector>

#include "cli/arguments.hpp"
#include "denoise/denoise.hpp"

namespace fogcomp::cli {

/// The options that choose a wavelet denoising: --wavelet, --levels, --threshold, --mode.
std::vector<Option> denoise_options();

/// Their values.
DenoiseMethod denoise_method(const Arguments& arguments);

}  // namespace fogcomp::cli
