#pragma once

#include <optional>
#include <string>

#include "report/page_text.hpp"

namespace fogcomp::report {

/// Four significant digits of a quantity of any unit; whole numbers as they are.
Text significant(double value);

/// A rate in deg/h: four significant digits, no finer than the 1e-6 that a recording holds.
Text number(double rate_dph);
/// The same; "-" where there is none.
Text dph(const std::optional<double>& value);

/// "12 %"
std::string percent(double share);

/// Words as a sentence: a capital at the beginning, one full stop at the end.
std::string as_sentence(std::string words);

}  // namespace fogcomp::report
