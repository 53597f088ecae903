#include "identification/block_series.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp {

std::int64_t sample_number(const Recording& recording, std::size_t row) {
  if (row == 0) return 0;
  return std::llround((recording.time_s[row] - recording.time_s[0]) / recording.period_s);
}

std::uint32_t samples_per_block(double period_s) {
  const bool one_block_each = period_s >= 1 || period_s <= 0;  // 0: a single row has no period
  return one_block_each ? 1U : static_cast<std::uint32_t>(std::lround(1 / period_s));
}

BlockSeries make_blocks(const Recording& recording) {
  BlockSeries series;
  series.period_s = recording.period_s;
  series.samples_per_block = samples_per_block(recording.period_s);
  series.block_s = recording.period_s > 0 ? recording.period_s * series.samples_per_block : 1;
  series.first_temperature_degc = recording.temperature_degc[0];
  const bool has_input = !recording.input_rate_dph.empty();
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const std::int64_t number = sample_number(recording, row) / series.samples_per_block;
    if (series.blocks.empty() || series.blocks.back().number != number) {
      series.blocks.push_back({});
      series.blocks.back().number = number;
    }
    BlockSeries::Block& block = series.blocks.back();
    ++block.samples;
    block.time_s += recording.time_s[row];
    block.temperature_degc += recording.temperature_degc[row];
    block.rate_dph += recording.rate_dph[row];
    if (has_input) block.input_rate_dph += recording.input_rate_dph[row];
  }
  for (BlockSeries::Block& block : series.blocks) {
    const double samples = block.samples;
    block.time_s /= samples;
    block.temperature_degc /= samples;
    block.rate_dph /= samples;
    block.input_rate_dph /= samples;
  }
  return series;
}

}  // namespace fogcomp
