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
/// every sample. `first` and `means_of(i)`: what stands for the first sample and for the means of
/// block i.
template <class DriftModel, class MeansOf, class Visit>
void walk_blocks(const BlockSeries& series, const fog::BlockMeans<model::RealNumbers>& first,
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
    if (bridge.bridge_to(means, missing)) {
      model.see_rate(means.input_rate);
      visit(block);
      while (bridge.remaining() > 0) model.step(bridge.next());
    } else {
      model.start(means);
      bridge.start(means);
    }
  }
}

/// The same with the means as measured.
template <class DriftModel, class Visit>
void walk_blocks(const BlockSeries& series, DriftModel& model, Visit visit) {
  const auto measured = [&](std::size_t i) -> const fog::BlockMeans<model::RealNumbers>& {
    return series.blocks[i].means;
  };
  walk_blocks(series, series.first, measured, model, visit);
}

}  // namespace fogcomp::series
