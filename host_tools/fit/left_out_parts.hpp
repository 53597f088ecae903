#pragma once

#include <string>
#include <vector>

#include "noise/noise_model.hpp"
#include "recording/row_range.hpp"
#include "series/rows.hpp"

namespace fogcomp::fit {

/// Rows that are left out of a fit together, to be judged by it.
using Part = std::vector<recording::RowRange>;

/// Number of independent stretches of a run. `residual`: of the fit, one value per row.
double stretches_of(const series::Rows& rows, const std::vector<double>& residual,
                    const noise::NoiseModel& noise);

/// Assigns `count` stretches of time to five parts in turn. Every part contains some of each phase
/// of the run, so that it is interpolated, not extrapolated. Each run begins with another part, so
/// that its start is left out while the starts of the others are not.
std::vector<Part> parts_of(const series::Rows& rows, double count);

/// `count` parts, each with as much of every run, from its beginning to its end.
std::vector<Part> cut_runs(const series::Rows& rows, std::size_t count);

/// Rows in ramps: heating, cooling (rules::kRampDegcPerMin).
std::vector<Part> directions_of(const series::Rows& rows);

/// A third of the rows each: the coldest, the middle, the warmest.
std::vector<Part> temperatures_of(const series::Rows& rows);

/// "on stretches of 7.08 min, a fifth of them left out in turn"
std::string how_of(const std::vector<Part>& parts, const series::Rows& rows);

}  // namespace fogcomp::fit
