#include "series/block_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "recording/data_hash.hpp"
#include "recording/recording.hpp"
#include "recording/row_range.hpp"
#include "series/decision_rules.hpp"
#include "series/measured_temperature.hpp"
#include "support/input_error.hpp"

namespace fogcomp::series {
namespace {

using Means = fog::BlockMeans<model::RealNumbers>;

Means means_of_row(const recording::Recording& recording, std::size_t row) {
  Means means;
  means.temperature = recording.temperature_degc[row];
  if (!recording.input_rate_dph.empty()) means.input_rate = recording.input_rate_dph[row];
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    const std::vector<double>& column = recording.extension[i];
    if (!column.empty()) means.extension[i] = column[row];
  }
  return means;
}

void add(Means& sum, const Means& means) {
  sum.temperature += means.temperature;
  sum.input_rate += means.input_rate;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) sum.extension[i] += means.extension[i];
}

void divide(Means& sum, double samples) {
  sum.temperature /= samples;
  sum.input_rate /= samples;
  for (double& value : sum.extension) value /= samples;
}

// Sums become means.
void make_means(BlockSeries::Block& block) {
  const double samples = block.samples;
  block.time_s /= samples;
  block.rate_dph /= samples;
  divide(block.means, samples);
}

void mark_masked(const std::vector<recording::Mask>& masks, BlockSeries& series) {
  std::vector<double> times;
  for (const BlockSeries::Block& block : series.blocks) times.push_back(block.time_s);
  const std::vector<bool> masked = recording::covered(masks, times);
  for (std::size_t i = 0; i < masked.size(); ++i) series.blocks[i].masked = masked[i];
}

// A recording whose time starts before power-on has no time since power-on. A first stamp that is
// early by less than a sample has only jitter.
fog::InputMask inputs_of(const recording::Recording& recording) {
  fog::InputMask inputs = 0;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    if (!recording.extension[i].empty()) inputs |= bit_of(fog::extension_input(i));
  }
  if (!recording.input_rate_dph.empty()) inputs |= bit_of(fog::Input::input_rate);
  if (recording.time_s[0] > -recording.period_s) inputs |= bit_of(fog::Input::elapsed);
  return inputs;
}

// Where a reading changes more than once in a block, their mean has no steps that matter.
double temperature_step_degc(const recording::Recording& recording, const BlockSeries& series) {
  if (recording.temperature_period_s >= series.block_s) return recording.temperature_step_degc;
  double step_degc = HUGE_VAL;
  std::size_t changes = 0;
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    const double change =
        std::abs(recording.temperature_degc[row] - recording.temperature_degc[row - 1]);
    if (change == 0) continue;
    step_degc = std::min(step_degc, change);
    ++changes;
  }
  return changes == 0 || changes > series.blocks.size() ? 0 : step_degc;
}

// Blocks from one line of a table to the next: more than a board bridges.
constexpr int kDwellBlocks = 1000;
constexpr double kDwellBlockS = 10;

// The gyro has settled at the temperature of a table's line before that is measured: a block from
// which the model starts, whose own rate does not count.
void add_settled_blocks(BlockSeries& series) {
  std::vector<BlockSeries::Block> blocks;
  auto steady = std::make_shared<MeasuredTemperature>();
  for (const BlockSeries::Block& measured : series.blocks) {
    blocks.push_back(measured);
    blocks.back().number -= 1;
    blocks.back().masked = true;
    blocks.push_back(measured);
    steady->parts.push_back({measured.number - 1, {{measured.means.temperature, 0}}});
  }
  series.blocks = std::move(blocks);
  series.temperature = std::move(steady);
}

using PowerOn = model::RealNumbers::PowerOn;

// The last power-on before a row: time_s is since then unless the uptime says more. `before`: that
// of the row before it.
PowerOn power_on_at(const recording::Recording& recording, std::size_t row, double block_s,
                    const PowerOn& before) {
  if (recording.uptime_s.empty()) return {};
  PowerOn start;
  start.at = (recording.time_s[row] - recording.uptime_s[row]) / block_s;
  if (row == 0) return start;
  const double off = recording.time_s[row - 1] / block_s;
  start.was_on = off - before.at;
  start.was_off = start.at - off;
  return start;
}

// Changes across a gap are not used.
model::InputRanges input_ranges_of(const recording::Recording& recording) {
  model::InputRanges ranges{};
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    const std::vector<double>& column = recording.extension[i];
    if (column.empty()) continue;
    const auto [min, max] = std::minmax_element(column.begin(), column.end());
    model::InputRange& range = ranges[i].emplace(model::InputRange{{*min, *max}});
    for (std::size_t row = 1; row < column.size(); ++row) {
      if (recording::is_gap(recording.time_s[row] - recording.time_s[row - 1], recording.period_s))
        continue;
      range.step = std::max(range.step, std::abs(column[row] - column[row - 1]));
    }
  }
  return ranges;
}

// Of blocks that begin with `first_rows`.
void set_rates_within(const recording::Recording& recording,
                      const std::vector<std::size_t>& first_rows, BlockSeries& series) {
  const std::vector<double>& rate_dph = recording.input_rate_dph;
  if (rate_dph.empty()) return;
  const auto changes_within = [&](std::size_t i) {
    const auto first = rate_dph.begin() + static_cast<std::ptrdiff_t>(first_rows[i]);
    const auto [min, max] = std::minmax_element(first, first + series.blocks[i].samples);
    return *max - *min > rules::kMinChangeOfRate_dph;
  };
  std::vector<bool> changing(series.blocks.size());
  std::size_t size = 0;
  for (std::size_t i = 0; i < changing.size(); ++i) {
    changing[i] = changes_within(i);
    if (changing[i]) size += series.blocks[i].samples;
  }
  auto kept = std::make_shared<std::vector<double>>();
  kept->reserve(size);  // pointers into it stay valid
  for (std::size_t i = 0; i < changing.size(); ++i) {
    model::RealNumbers::RateWithin& within = series.blocks[i].means.rate_within;
    // That of a whole block, from the samples that are there.
    const std::uint32_t samples = series.blocks[i].samples;
    within = rise_of_input_rate(recording, first_rows[i], samples,
                                static_cast<double>(series.samples_per_block) / samples);
    if (!changing[i]) continue;
    const auto first = rate_dph.begin() + static_cast<std::ptrdiff_t>(first_rows[i]);
    within.samples = kept->data() + kept->size();
    within.count = series.blocks[i].samples;
    kept->insert(kept->end(), first, first + series.blocks[i].samples);
  }
  series.input_rates.push_back(std::move(kept));
}

void require_unmasked(const BlockSeries& series) {
  const auto& blocks = series.blocks;
  if (std::any_of(blocks.begin(), blocks.end(), [](const auto& block) { return !block.masked; }))
    return;
  throw InputError(series.file, "is masked from end to end; mask less, or leave the run out");
}

// Whether the second differences at four samples are those of a smooth curve: without a corner
// they change evenly from one to the next.
bool is_smooth(const std::array<double, 4>& bends) {
  double max_bend = 0;
  for (const double bend : bends) max_bend = std::max(max_bend, std::abs(bend));
  const double unevenness = std::max(std::abs(bends[0] - 2 * bends[1] + bends[2]),
                                     std::abs(bends[1] - 2 * bends[2] + bends[3]));
  return std::isfinite(max_bend) && unevenness <= rules::kMaxUnevenness * max_bend;
}

// The straight line through two neighbouring means, between them and at its ends.
Edge between(double a, double b) {
  return {(a + b) / 2, b - a};
}
Edge behind(double a, double b) {
  return {(3 * b - a) / 2, b - a};
}
Edge before(double a, double b) {
  return {(3 * a - b) / 2, b - a};
}

}  // namespace

model::RealNumbers::RateWithin rise_of_input_rate(const recording::Recording& recording,
                                                  std::size_t first, std::uint32_t rows,
                                                  double times) {
  const std::vector<double>& rate_dph = recording.input_rate_dph;
  const std::vector<std::size_t>& starts = recording.stretch_starts;
  const auto next = std::upper_bound(starts.begin(), starts.end(), first);
  const std::size_t begin = *(next - 1);
  const std::size_t end = next == starts.end() ? rate_dph.size() : *next;
  const auto row = static_cast<std::ptrdiff_t>(first - begin);
  const auto size = static_cast<std::ptrdiff_t>(end - begin);
  const auto at_end_of = [&](std::ptrdiff_t k) {
    return edge_at_end_of(rate_dph.data() + begin, size, std::min(k, size - 1));
  };
  const Edge begin_edge = at_end_of(row - 1);
  const Edge end_edge = at_end_of(row + static_cast<std::ptrdiff_t>(rows) - 1);
  model::RealNumbers::RateWithin within;
  within.rise = times * (end_edge.value - begin_edge.value);
  if (recording.period_s > 0) {
    within.rise_of_slope = times * (end_edge.slope - begin_edge.slope) / recording.period_s;
  }
  return within;
}

std::int64_t sample_number(const recording::Recording& recording, std::size_t row) {
  if (recording.is_table) return std::int64_t{kDwellBlocks} * static_cast<std::int64_t>(row) + 1;
  if (row == 0) return 0;
  return std::llround((recording.time_s[row] - recording.time_s[0]) / recording.period_s);
}

std::uint32_t samples_per_block(double period_s) {
  const bool one_block_each = period_s >= 1 || period_s <= 0;  // 0: a single row has no period
  return one_block_each ? 1U : static_cast<std::uint32_t>(std::lround(1 / period_s));
}

void widen(model::InputRanges& ranges, const model::InputRanges& by) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!by[i]) continue;
    if (!ranges[i]) ranges[i] = by[i];
    model::InputRange& range = *ranges[i];
    range.range.min = std::min(range.range.min, by[i]->range.min);
    range.range.max = std::max(range.range.max, by[i]->range.max);
    range.step = std::max(range.step, by[i]->step);
  }
}

namespace {

// All that is known before the blocks are formed.
BlockSeries without_blocks(const recording::Recording& recording) {
  BlockSeries series;
  series.file = recording.file;
  series.recordings = {recording::rows_hash(recording)};
  series.period_s = recording.period_s;
  series.samples_per_block = samples_per_block(recording.period_s);
  series.block_s = recording.period_s > 0 ? recording.period_s * series.samples_per_block : 1;
  series.is_table = recording.is_table;
  if (recording.is_table) series.period_s = series.block_s = kDwellBlockS;
  series.inputs = inputs_of(recording);
  series.input_ranges = input_ranges_of(recording);
  series.rounding_dph = recording::rate_resolution(recording).rounding_dph();
  series.first = means_of_row(recording, 0);
  series.first.elapsed = recording.time_s[0] / series.block_s;
  series.first.power_on = power_on_at(recording, 0, series.block_s, {});
  return series;
}

}  // namespace

bool set_cut(BlockSeries& series, double at_s, bool cut) {
  const auto holds = [&](const BlockSeries::Block& block) {
    return block.time_s + series.block_s / 2 > at_s;
  };
  const auto block = std::find_if(series.blocks.begin(), series.blocks.end(), holds);
  // Nothing lies before the first one.
  if (block == series.blocks.end() || block == series.blocks.begin()) return false;
  block->cut = cut;
  return true;
}

BlockSeries make_blocks(const recording::Recording& recording) {
  BlockSeries series = without_blocks(recording);
  const std::int64_t blocks =
      sample_number(recording, recording.rows() - 1) / series.samples_per_block + 1;
  std::vector<std::size_t> first_rows;
  PowerOn power_on = series.first.power_on;
  series.blocks.reserve(std::min(recording.rows(), static_cast<std::size_t>(blocks)));
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const std::int64_t number = sample_number(recording, row) / series.samples_per_block;
    if (series.blocks.empty() || series.blocks.back().number != number) {
      series.blocks.push_back({});
      series.blocks.back().number = number;
      first_rows.push_back(row);
    }
    BlockSeries::Block& block = series.blocks.back();
    if (recording.restarts_at(row)) {
      block.restarts = true;
      power_on = power_on_at(recording, row, series.block_s, power_on);
    }
    block.means.power_on = power_on;
    ++block.samples;
    block.time_s += recording.time_s[row];
    block.rate_dph += recording.rate_dph[row];
    const bool is_read =
        recording.temperature_is_read.empty() || recording.temperature_is_read[row];
    block.has_reading = block.has_reading || is_read;
    add(block.means, means_of_row(recording, row));
  }
  for (BlockSeries::Block& block : series.blocks) {
    make_means(block);
    block.means.elapsed = series.first.elapsed + static_cast<double>(block.number) + 1;
  }
  mark_masked(recording.masks, series);
  set_rates_within(recording, first_rows, series);
  if (recording.is_table) {
    add_settled_blocks(series);
  } else {
    series.temperature_step_degc = temperature_step_degc(recording, series);
  }
  require_unmasked(series);
  return series;
}

Edge edge_at_end_of(const double* stretch, std::ptrdiff_t size, std::ptrdiff_t i) {
  const auto bend = [&](std::ptrdiff_t k) {
    if (k < 1 || k + 1 >= size) return std::numeric_limits<double>::infinity();
    return stretch[k - 1] - 2 * stretch[k] + stretch[k + 1];
  };
  const double* const at = stretch + i;
  if (i < 0) return i + 2 < size ? before(at[1], at[2]) : Edge{at[1]};
  if (i + 1 == size) return i >= 1 ? behind(at[-1], at[0]) : Edge{at[0]};
  const std::array<double, 4> bends{bend(i - 1), bend(i), bend(i + 1), bend(i + 2)};
  if (is_smooth(bends)) {
    return {(7 * (at[0] + at[1]) - at[-1] - at[2]) / 12,
            (15 * (at[1] - at[0]) - (at[2] - at[-1])) / 12};
  }
  const double bend_before = std::abs(bends[0]);
  const double bend_across = std::max(std::abs(bends[1]), std::abs(bends[2]));
  const double bend_after = std::abs(bends[3]);
  if (bend_before < bend_across && bend_before <= bend_after) return behind(at[-1], at[0]);
  if (bend_after < bend_across) return before(at[1], at[2]);
  return between(at[0], at[1]);
}

}  // namespace fogcomp::series
