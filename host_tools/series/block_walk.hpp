#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/thermal/block_bridge.hpp"
#include "recording/board_limits.hpp"
#include "series/block_series.hpp"
#include "series/measured_temperature.hpp"

namespace fogcomp::series {

inline std::uint32_t hold_blocks(double block_s) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(recording::kHoldSeconds / block_s)));
}

/// Gaps over which the temperature of a gyro that stays on is known well enough: a logger that
/// writes a minute of each ten or thirty.
constexpr double kBridged_s = 1800;

inline std::int64_t bridged_blocks(double block_s) {
  return std::max<std::int64_t>(hold_blocks(block_s), std::llround(kBridged_s / block_s));
}

/// Calls visit(first, end) for the blocks of every part without a longer gap or a power-on.
template <class Visit>
void each_part(const BlockSeries& series, const Visit& visit) {
  const std::int64_t bridged = bridged_blocks(series.block_s);
  std::size_t first = 0;
  for (std::size_t end = 1; end <= series.blocks.size(); ++end) {
    const bool goes_on = end < series.blocks.size() && !series.blocks[end].restarts &&
                         series.blocks[end].number - series.blocks[end - 1].number - 1 <= bridged;
    if (goes_on) continue;
    visit(first, end);
    first = end;
  }
}

/// Runs a model (start(means), step(means), see_rate(means), forget()) over a recording as a board
/// that has settled: the first sample starts it; a block's means act from the next block on; a gap
/// is bridged by the board's own rule or, if longer than the board holds its drift, along the
/// measured temperature, without a drift for the block that ends it. After still longer ones the
/// model restarts, as at a power-on; each line of a table is the first one of a model that has seen
/// nothing. Calls visit(block) for every block with a valid drift, before that block's means are
/// used; its input rate has been passed already, because the board has it at every sample. `first`
/// and `means_of(i)`: values for the first sample and the means of block i.
template <class DriftModel, class MeansOf, class Visit>
void run_blocks(const BlockSeries& series, const fog::BlockMeans<model::RealNumbers>& first,
                const MeansOf& means_of, DriftModel& model, Visit visit) {
  const std::int64_t held = hold_blocks(series.block_s);
  const std::int64_t bridged = bridged_blocks(series.block_s);
  fog::BlockBridge<model::RealNumbers> bridge(static_cast<std::uint32_t>(bridged));
  std::shared_ptr<const MeasuredTemperature> own;
  model.start(first);
  bridge.start(first);
  std::int64_t before = -1;
  for (std::size_t i = 0; i < series.blocks.size(); ++i) {
    const BlockSeries::Block& block = series.blocks[i];
    const fog::BlockMeans<model::RealNumbers>& means = means_of(i);
    const std::int64_t missing = block.number - before - 1;
    const bool is_held = missing <= held;
    before = block.number;
    if (!block.restarts &&
        bridge.bridge_to(means, static_cast<std::uint32_t>(std::min(missing, bridged + 1)))) {
      model.see_rate(means);
      if (is_held) visit(block);
      if (!is_held && !own) own = temperature_of(series);
      while (bridge.remaining() > 0) {
        fog::BlockMeans<model::RealNumbers> next = bridge.next();
        const std::int64_t left = bridge.remaining();
        if (!is_held && left > 0) next.temperature = own->at(block.number - left).degc;
        model.step(next);
      }
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
