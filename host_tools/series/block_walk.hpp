#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/thermal/block_bridge.hpp"
#include "recording/board_limits.hpp"
#include "series/block_series.hpp"

namespace fogcomp::series {

inline std::uint32_t hold_blocks(double block_s) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(recording::kHoldSeconds / block_s)));
}

/// Leads a model (start(means), step(means), see_rate(mean input rate)) through a recording as the
/// board leads its own: started by the first sample; a block's means count from the next block on;
/// a gap is bridged by the board's own rule, or, longer than the board holds its drift, starts the
/// model anew. Calls visit(block) for every block in which the drift is valid, before the block's
/// own means have moved the model; of these it has seen the input rate, which the board has at
/// every sample.
template <class DriftModel, class Visit>
void walk_blocks(const BlockSeries& series, DriftModel& model, Visit visit) {
  const std::int64_t too_many = std::int64_t{hold_blocks(series.block_s)} + 1;
  fog::BlockBridge<model::RealNumbers> bridge(hold_blocks(series.block_s));
  model.start(series.first);
  bridge.start(series.first);
  std::int64_t before = -1;
  for (const BlockSeries::Block& block : series.blocks) {
    const auto missing = static_cast<std::uint32_t>(std::min(block.number - before - 1, too_many));
    before = block.number;
    if (bridge.aim(block.means, missing)) {
      model.see_rate(block.means.input_rate);
      visit(block);
      while (bridge.left() > 0) model.step(bridge.next());
    } else {
      model.start(block.means);
      bridge.start(block.means);
    }
  }
}

}  // namespace fogcomp::series
