#include "series/complete_rows.hpp"

#include <algorithm>
#include <cmath>

#include "recording/columns.hpp"
#include "recording/segments.hpp"

namespace fogcomp::series {
namespace {

// Sums the differences from the first value, so that the mean of equal values is exact.
double mean(const double* values, std::size_t size) {
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += values[i] - values[0];
  return values[0] + sum / static_cast<double>(size);
}

recording::RowRange longest(const std::vector<recording::RowRange>& stretches) {
  return *std::max_element(
      stretches.begin(), stretches.end(),
      [](recording::RowRange a, recording::RowRange b) { return a.size() < b.size(); });
}

}  // namespace

std::size_t samples_per_row(const recording::Recording& recording, double average_s) {
  if (!(recording.period_s > 0)) return 1;
  const double samples = std::round(average_s / recording.period_s);
  return static_cast<std::size_t>(
      std::clamp(samples, 1.0, static_cast<double>(recording::kMaxRows)));
}

CompleteRows complete_rows(const recording::Recording& recording, double average_s) {
  const std::vector<recording::RowRange> all =
      recording::stretches_of(recording, {0, recording.rows()});
  CompleteRows rows;
  rows.samples_per_row = samples_per_row(recording, average_s);
  std::vector<recording::RowRange> stretches = all;
  if (longest(all).size() < rows.samples_per_row) {
    stretches = {longest(all)};
    rows.samples_per_row = stretches.front().size();
  }
  for (const recording::RowRange& stretch : stretches) {
    const std::size_t count = stretch.size() / rows.samples_per_row;
    if (count > 0) rows.means.stretch_starts.push_back(rows.first_samples.size());
    for (std::size_t i = 0; i < count; ++i) {
      rows.first_samples.push_back(stretch.first + i * rows.samples_per_row);
    }
  }
  rows.means.file = recording.file;
  rows.means.is_table = recording.is_table;
  rows.means.period_s = recording.period_s * static_cast<double>(rows.samples_per_row);
  for (const recording::ColumnInfo& column : recording::kColumns) {
    const std::vector<double>& values = recording[column.column];
    if (values.empty()) continue;
    std::vector<double>& means = rows.means[column.column];
    means.reserve(rows.first_samples.size());
    for (const std::size_t first : rows.first_samples) {
      means.push_back(mean(values.data() + first, rows.samples_per_row));
    }
  }
  return rows;
}

}  // namespace fogcomp::series
