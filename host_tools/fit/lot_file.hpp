#pragma once

#include <string>

#include "fit/lot.hpp"

namespace fogcomp::fit {

/// A lot as text: a line for each sister with what her recordings say, a CRC-32 of them, then the
/// mean gyro's model file (host_tools/REFERENCE.md, "Lot file").
std::string lot_text(const Lot& lot);

/// Parses lot_text(). `file` is its name for errors: InputError for a file that is no lot or is
/// damaged.
Lot parse_lot(const std::string& text, const std::string& file);

}  // namespace fogcomp::fit
