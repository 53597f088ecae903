#pragma once

#include <optional>
#include <string>

#include "findings/text.hpp"

namespace fogcomp::findings {

/// Four significant digits of a quantity of any unit; whole numbers as they are.
Text significant(double value);

/// A rate in deg/h: four significant digits, no finer than the 1e-6 that a recording holds.
Text number(double rate_dph);
/// The same; "-" where there is none.
Text dph(const std::optional<double>& value);

/// "12 %"
std::string percent(double share);

}  // namespace fogcomp::findings
