#include "recording/reading.hpp"

#include <algorithm>

#include "recording/columns.hpp"

namespace fogcomp::recording {
namespace {

std::vector<Recording::Label> labels_without(const Recording& recording,
                                             const std::vector<std::size_t>& removed) {
  std::vector<Recording::Label> labels;
  for (const Recording::Label& label : recording.labels) {
    const auto after = std::lower_bound(removed.begin(), removed.end(), label.first_row);
    const std::size_t first_row =
        label.first_row - static_cast<std::size_t>(after - removed.begin());
    if (!labels.empty() && labels.back().first_row == first_row) labels.pop_back();
    if (!labels.empty() && labels.back().text == label.text) continue;
    labels.push_back({first_row, label.text});
  }
  const std::size_t rows_left = recording.rows() - removed.size();
  if (!labels.empty() && labels.back().first_row == rows_left) labels.pop_back();
  return labels;
}

void remove_from(std::vector<double>& column, const std::vector<std::size_t>& removed) {
  if (column.empty()) return;
  std::size_t kept = removed.front();
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const std::size_t end = i + 1 < removed.size() ? removed[i + 1] : column.size();
    for (std::size_t row = removed[i] + 1; row < end; ++row) column[kept++] = column[row];
  }
  column.resize(kept);
}

}  // namespace

void remove_rows(Recording& recording, const std::vector<std::size_t>& rows) {
  if (rows.empty()) return;
  recording.labels = labels_without(recording, rows);
  for (const ColumnInfo& info : kColumns) remove_from(recording[info.column], rows);
}

}  // namespace fogcomp::recording
