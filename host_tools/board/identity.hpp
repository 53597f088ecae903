#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/pipeline/model_parameters.hpp"

namespace fogcomp::board {

using ProcessorNumber = std::array<std::uint32_t, fog::kProcessorWords>;

/// The serial number as stored in a table and a health record: ASCII, padded with 0. Throws
/// InputError if it does not fit.
std::array<std::uint32_t, fog::kSerialWords> serial_words(const std::string& serial);
/// Inverse of serial_words(); empty: none.
std::string serial_text(const std::uint32_t* words);

/// Parses 24 hexadecimal digits, as printed by `fogcomp health`. Throws InputError.
ProcessorNumber parse_processor_number(const std::string& text);
std::string processor_text(const ProcessorNumber& number);

}  // namespace fogcomp::board
