#pragma once

#include <string>
#include <vector>

#include "recording/columns.hpp"

namespace fogcomp::recording {

/// What a header's names say of units, so that no message proposes to rename a column that would
/// have to be converted.

/// Whether `name` ("rate_dps", "Gyro [deg/s]", "time_ms") is of a quantity that recordings have, in
/// another unit.
bool has_foreign_unit(const std::string& name);

/// How to make `column` of those of `names` that hold it in another unit, or of several axes; ""
/// where none does.
std::string how_to_convert(Column column, const std::vector<std::string>& names);

}  // namespace fogcomp::recording
