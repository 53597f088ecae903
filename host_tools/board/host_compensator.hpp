#pragma once

#include "core/denoise/any_denoiser.hpp"
#include "core/pipeline/compensator.hpp"

namespace fogcomp::board {

/// The firmware's own pipeline with capacity for any model.
using HostCompensator =
    fog::Compensator<fog::kAllEffects, fog::kAnyModel.expressions, fog::kAnyModel.network_inputs,
                     fog::kAnyTaps, fog::kAnyModel.levels>;

}  // namespace fogcomp::board
