#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/pipeline/model_parameters.hpp"

namespace fogcomp::board {

using ProcessorNumber = std::array<std::uint32_t, fog::kProcessorWords>;

/// The serial number as a table and a health record hold it, ASCII, padded with 0. Throws
/// InputError where they cannot.
std::array<std::uint32_t, fog::kSerialWords> serial_words(const std::string& serial);
/// The other way; empty: none.
std::string serial_text(const std::uint32_t* words);

/// 24 hexadecimal digits, as `fogcomp health` prints them. Throws InputError.
ProcessorNumber parse_processor_number(const std::string& text);
std::string processor_text(const ProcessorNumber& number);

}  // namespace fogcomp::board
