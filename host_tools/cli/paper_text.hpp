#pragma once

#include <vector>

#include "research/gyros.hpp"
#include "support/json.hpp"

namespace fogcomp::cli {

/// The tables of `fogcomp paper`: the printed figures beside those of the first gyro, then medians
/// over all.
void print_paper(const std::vector<Study>& studies);
Json paper_json(const std::vector<Study>& studies);

}  // namespace fogcomp::cli
