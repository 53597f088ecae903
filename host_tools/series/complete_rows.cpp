#include "series/blocks.hpp"

#include <algorithm>
#include <cmath>

#include "recording/columns.hpp"
#include "recording/segments.hpp"

namespace fogcomp {
namespace {

// Sum over the offset from the first value, so that a mean of equal values is that value.
double mean(const double* values, std::size_t size) {
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += values[i] - values[0];
  return values[0] + sum / static_cast<double>(size);
}

RowRange longest(const std::vector<RowRange>& stretches) {
  return *std::max_element(stretches.begin(), stretches.end(),
                           [](RowRange a, RowRange b) { return a.size() < b.size(); });
}

}  // namespace

std::size_t rows_per_block(const Recording& recording, double average_s) {
  if (!(recording.period_s > 0)) return 1;
  const double rows = std::round(average_s / recording.period_s);
  return static_cast<std::size_t>(std::clamp(rows, 1.0, static_cast<double>(kMostRows)));
}

Blocks block_means(const Recording& recording, double average_s) {
  const std::vector<RowRange> all = stretches_of(recording, {0, recording.rows()});
  Blocks blocks;
  blocks.rows_per_block = rows_per_block(recording, average_s);
  std::vector<RowRange> stretches = all;
  if (longest(all).size() < blocks.rows_per_block) {
    stretches = {longest(all)};
    blocks.rows_per_block = stretches.front().size();
  }
  for (const RowRange& stretch : stretches) {
    const std::size_t count = stretch.size() / blocks.rows_per_block;
    if (count > 0) blocks.means.stretch_starts.push_back(blocks.first_rows.size());
    for (std::size_t i = 0; i < count; ++i) {
      blocks.first_rows.push_back(stretch.first + i * blocks.rows_per_block);
    }
  }
  blocks.means.file = recording.file;
  blocks.means.period_s = recording.period_s * static_cast<double>(blocks.rows_per_block);
  for (const ColumnInfo& column : kColumns) {
    const std::vector<double>& values = recording[column.column];
    if (values.empty()) continue;
    std::vector<double>& means = blocks.means[column.column];
    means.reserve(blocks.first_rows.size());
    for (const std::size_t row : blocks.first_rows) {
      means.push_back(mean(values.data() + row, blocks.rows_per_block));
    }
  }
  return blocks;
}

}  // namespace fogcomp
