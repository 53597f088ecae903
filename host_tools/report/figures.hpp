#pragma once

#include <optional>
#include <string>

namespace fogcomp::report {

/// A rate in deg/h as the commands print it: four decimals; "-" where there is none.
std::string dph(const std::optional<double>& value);

/// "12 %"
std::string percent(double share);

/// Words as a sentence: a capital at the beginning, one full stop at the end.
std::string as_sentence(std::string words);

}  // namespace fogcomp::report
