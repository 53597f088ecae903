#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/frames/serial_line.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "core/signal/status.hpp"

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

/// "115200,8E1", as given to options: bit rate, and data bits, parity and stop bits unless 8N1.
std::string line_text(fog::SerialLine line);

/// Inverse of line_text(). Throws InputError naming `option` unless the bit rate is within 9600 to
/// `max_baud` and the format is one of 8N1, 8N2, 8E1, 8E2, 8O1, 8O2.
fog::SerialLine parse_line(const std::string& text, std::uint32_t max_baud,
                           const std::string& option);

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
