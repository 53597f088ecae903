#include "cli/page_rows.hpp"

#include <filesystem>
#include <vector>

#include "recording/columns.hpp"
#include "recording/decimal.hpp"
#include "series/complete_rows.hpp"
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
