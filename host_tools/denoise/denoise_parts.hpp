#pragma once

#include <string>
#include <vector>

#include "denoise/denoise.hpp"

namespace fogcomp::denoise {

/// Denoises the parts of a signal between its gaps, separately and in place. A part too short for
/// all levels uses as many as its length allows. Returns the report of the longest part, with the
/// outliers and shortened values of all. Throws InputError naming `where` if even the longest part
/// is too short.
DenoiseReport denoise_parts(const std::vector<fog::Span<double>>& parts,
                            const DenoiseMethod& method, const std::string& where);

}  // namespace fogcomp::denoise
