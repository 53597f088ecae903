#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "recording/board_limits.hpp"
#include "series/block_series.hpp"

namespace fogcomp {

inline std::uint32_t hold_blocks(double block_s) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(kHoldSeconds / block_s)));
}

/// Leads a model (start(means), step(means)) through a recording as the board leads its own:
/// started by the first sample; a block's means count from the next block on; after a gap longer
/// than the board holds its drift, started anew. Calls visit(block) for every block in which the
/// drift is valid, before the block's own means have moved the model.
template <class DriftModel, class Visit>
void walk_blocks(const BlockSeries& series, DriftModel& model, Visit visit) {
  const auto most_held = static_cast<std::int64_t>(hold_blocks(series.block_s));
  model.start(series.first);
  bool given_up = false;
  for (std::size_t i = 0; i < series.blocks.size(); ++i) {
    const BlockSeries::Block& block = series.blocks[i];
    if (i > 0) given_up = block.number - series.blocks[i - 1].number - 1 > most_held;
    if (!given_up) visit(block);
    if (given_up) {
      model.start(block.means);
    } else {
      model.step(block.means);
    }
  }
}

}  // namespace fogcomp
