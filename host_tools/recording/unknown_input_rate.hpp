#pragma once

#include <string>
#include <vector>

#include "recording/mask.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Masks times in which the input rate is not known, and says so: "fits and comparisons leave out
/// 12 s WHICH, the first at 3 s; REMEDY". Nothing without masks.
void mask_unknown_input_rate(Recording& recording, const std::vector<Mask>& unknown,
                             const std::string& which, const std::string& remedy,
                             const ReadWatch& watch);

}  // namespace fogcomp::recording
