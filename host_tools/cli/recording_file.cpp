#include "cli/recording_file.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "recording/columns.hpp"
#include "recording/csv_fields.hpp"
#include "recording/recording_writer.hpp"
#include "series/complete_rows.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::string csv_of(const recording::Recording& recording) {
  std::vector<const recording::ColumnInfo*> columns;
  std::vector<std::string> names;
  for (const recording::ColumnInfo& info : recording::kColumns) {
    if (recording[info.column].empty()) continue;
    columns.push_back(&info);
    names.emplace_back(info.name);
  }
  std::string text = join(names, ",") + "\n";
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    for (const recording::ColumnInfo* info : columns) {
      char digits[recording::kLongestDecimal];
      char* const end =
          recording::print_fixed(recording[info->column][row], info->decimals, digits);
      text.append(digits, static_cast<std::size_t>(end - digits));
      text += info == columns.back() ? '\n' : ',';
    }
  }
  return text;
}

}  // namespace

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

bool is_too_large(const std::string& path) {
  constexpr std::size_t kMaxPageFile = 4'000'000;  // about 100,000 rows
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return !error && size > kMaxPageFile;
}

std::string words_of(const PageRows& rows, const std::string& path) {
  return format(
      "%s has %zu samples; the workbench has their %zu means over 1 s, so its figures agree with "
      "the command line's to some digits only",
      path.c_str(), rows.samples, rows.rows);
}

PageRows page_rows(const std::string& path, const recording::ReadOptions& options) {
  constexpr double kBlock_s = 1;
  const recording::Recording recording = recording::read_recording(path, options);
  const series::CompleteRows rows = series::complete_rows(recording, kBlock_s);
  return {csv_of(rows.means), recording.rows() * recording.rows_per_row, rows.means.rows()};
}

}  // namespace fogcomp::cli
