#pragma once

#include <optional>
#include <string>

#include "findings/text.hpp"

namespace fogcomp::findings {

/// Four significant digits of a value in any unit; whole numbers unchanged.
Text significant(double value);

/// A rate in deg/h: four significant digits, no finer than the 1e-6 of a recording.
Text number(double rate_dph);
/// The same; "-" if there is none.
Text dph(const std::optional<double>& value);

/// "0.0424 +- 0.0067": a value and its standard deviation in the same unit, both to the second
/// digit of the latter. `sign`: "+" before a positive value.
std::string with_sigma(double value, double sigma, bool sign = false);

/// "12 %"
std::string percent(double share);

}  // namespace fogcomp::findings
