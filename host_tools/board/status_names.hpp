#pragma once

#include <string>
#include <vector>

#include "core/signal/status.hpp"

namespace fogcomp::board {

/// Names of the flags that are set, as in firmware/SPEC.md, in the order of their bits.
std::vector<std::string> flag_names(fog::Status status);

/// Parses `NAME,NAME,...` or `none`; each flag must be in `allowed`. Throws InputError that begins
/// with `who` and lists the allowed names.
fog::Status parse_flags(const std::string& list, fog::Status allowed, const std::string& who);

/// Default flags that make a rate invalid beside fog::kRateInvalid: no measurement yet, or the
/// drift is less certain than the model's error.
constexpr fog::Status kDefaultInvalidating =
    fog::Status::denoiser_filling | fog::Status::thermal_settling | fog::Status::input_missing |
    fog::Status::drift_outdated;

}  // namespace fogcomp::board
