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

/// Calls visit(first, end) for the blocks of every part in which the board does not restart.
template <class Visit>
void each_part(const BlockSeries& series, const Visit& visit) {
  const auto max_held = static_cast<std::int64_t>(hold_blocks(series.block_s));
  std::size_t first = 0;
  for (std::size_t end = 1; end <= series.blocks.size(); ++end) {
    const bool goes_on = end < series.blocks.size() && !series.blocks[end].restarts &&
                         series.blocks[end].number - series.blocks[end - 1].number - 1 <= max_held;
    if (goes_on) continue;
    visit(first, end);
    first = end;
  }
}

/// Runs a model (start(means), step(means), see_rate(means), forget()) over a recording like the
/// board: the first sample starts it; a block's means act from the next block on; a gap is bridged
/// by the board's own rule or, if longer than the board holds its drift, restarts the model, as a
/// power-on does; each line of a table is the first one of a model that has seen nothing. Calls
/// visit(block) for every block with a valid drift, before that block's means are used; its input
/// rate has been passed already, because the board has it at every sample. `first` and
/// `means_of(i)`: values for the first sample and the means of block i.
template <class DriftModel, class MeansOf, class Visit>
void run_blocks(const BlockSeries& series, const fog::BlockMeans<model::RealNumbers>& first,
                const MeansOf& means_of, DriftModel& model, Visit visit) {
  const std::int64_t too_many = std::int64_t{hold_blocks(series.block_s)} + 1;
  fog::BlockBridge<model::RealNumbers> bridge(hold_blocks(series.block_s));
  model.start(first);
  bridge.start(first);
  std::int64_t before = -1;
  for (std::size_t i = 0; i < series.blocks.size(); ++i) {
    const BlockSeries::Block& block = series.blocks[i];
    const fog::BlockMeans<model::RealNumbers>& means = means_of(i);
    const auto missing = static_cast<std::uint32_t>(std::min(block.number - before - 1, too_many));
    before = block.number;
    if (!block.restarts && bridge.bridge_to(means, missing)) {
      model.see_rate(means);
      visit(block);
      while (bridge.remaining() > 0) model.step(bridge.next());
    } else {
      if (series.is_table) model.forget();
      model.start(means);
      bridge.start(means);
    }
  }
}

/// The same with the measured means.
template <class DriftModel, class Visit>
void run_blocks(const BlockSeries& series, DriftModel& model, Visit visit) {
  const auto measured = [&](std::size_t i) -> const fog::BlockMeans<model::RealNumbers>& {
    return series.blocks[i].means;
  };
  run_blocks(series, series.first, measured, model, visit);
}

}  // namespace fogcomp::series
