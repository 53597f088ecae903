#pragma once

#include <string>
#include <vector>

#include "core/signal/status.hpp"

namespace fogcomp::board {

/// Names of the flags that are set, as firmware/SPEC.md has them, in the order of their bits.
std::vector<std::string> flag_names(fog::Status status);

/// The flags of a list `NAME,NAME,...`, or `none`, each of which is one of `allowed`. Throws
/// InputError that begins with `who` and names those that are.
fog::Status parse_flags(const std::string& list, fog::Status allowed, const std::string& who);

/// What makes a rate not valid beside fog::kRateInvalid, unless a calibration says otherwise: there
/// is no measurement yet, or the drift is known worse than the model can say.
constexpr fog::Status kDefaultInvalidating =
    fog::Status::denoiser_filling | fog::Status::thermal_settling | fog::Status::input_missing |
    fog::Status::drift_outdated;

}  // namespace fogcomp::board
