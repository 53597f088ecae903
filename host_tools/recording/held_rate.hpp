#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::recording {

/// Whether lengths, in rows, scatter less than those between events that come by chance: these have
/// a geometric distribution, of variance m (m - 1) for a mean m, kurtosis 9 + 1 / (m (m - 1)).
/// False where there are too few to tell.
bool are_regular(const std::vector<double>& lengths);

/// Rows that repeat a reading, of a rate that is logged faster than the gyro delivers: it changes
/// in a rhythm that is slower than the rows. In such a series noise is averaged over time, not over
/// rows. Empty if the rate changes from row to row, or repeats by chance because it is coarse.
std::vector<std::size_t> repeated_readings(const std::vector<double>& rate_dph);

}  // namespace fogcomp::recording
