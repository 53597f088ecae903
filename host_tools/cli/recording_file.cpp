#include "cli/recording_file.hpp"

#include <algorithm>
#include <vector>

#include "recording/columns.hpp"
#include "recording/recording_writer.hpp"
#include "support/progress.hpp"

namespace fogcomp::cli {

void write_recording(const recording::Recording& recording, const std::string& path) {
  std::vector<recording::Column> columns;
  std::vector<const double*> values;
  for (const recording::ColumnInfo& info : recording::kColumns) {
    const std::vector<double>& column = recording[info.column];
    if (column.empty()) continue;
    columns.push_back(info.column);
    values.push_back(column.data());
  }
  recording::RecordingWriter writer(path, recording::RecordingFormat::csv, columns,
                                    recording::kDefaultScaleFactor,
                                    recording::kDefaultStreamRateHz);
  Progress progress("writing " + path);
  constexpr std::size_t kRowsAtOnce = 100'000;
  for (std::size_t first = 0; first < recording.rows(); first += kRowsAtOnce) {
    const std::size_t rows = std::min(kRowsAtOnce, recording.rows() - first);
    writer.append(values, rows);
    for (const double*& column : values) column += rows;
    progress.update(static_cast<double>(first + rows) / static_cast<double>(recording.rows()));
  }
  writer.commit();
}

}  // namespace fogcomp::cli
