#pragma once

#include <string>
#include <vector>

#include "recording/csv_header.hpp"
#include "recording/recording.hpp"
#include "recording/unit_spelling.hpp"

namespace fogcomp::recording {

/// Questions about a recording with values that no gyro, coil or chamber can have, which suggests
/// another unit: `FILE: what; what it may be`, one line each. `white_noise_dph_rthz`: of the rate,
/// deg/h in 1 s; 0 if unknown. Bounds: decision_rules.hpp.
std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz);

/// The first of them that a wrong unit of the time explains; "" for none.
std::string doubt_of_time(const Recording& recording);

/// What is wrong with rates in whole numbers that may be counts without a sign, of any width, or
/// that overflowed, and what decides. "" if their unit says it (int16, offset16, uint16). Else
/// they jump less round a counter of that width, or lie at half of what a converter of 16, 24 or
/// 32 bits with a sign has, or above.
std::string fault_of_signs(const std::vector<double>& rate_dph, const CsvHeader& header);

/// What is wrong with an input rate that the gyro sees, yet with another sign or half as large
/// again or more: another unit of either, with the options that give it. "" if nothing is.
std::string fault_of_input_rate(const Recording& recording, const CsvHeader& header);

}  // namespace fogcomp::recording
