#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Removes rows from every column. `rows`: in rising order. A label without remaining rows is
/// removed.
void remove_rows(Recording& recording, const std::vector<std::size_t>& rows);

}  // namespace fogcomp::recording
