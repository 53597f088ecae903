#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Takes rows out of every column. `rows`: in rising order. A label whose rows are all gone goes
/// with them.
void remove_rows(Recording& recording, const std::vector<std::size_t>& rows);

}  // namespace fogcomp::recording
