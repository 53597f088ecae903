#include "cli/recording_options.hpp"

#include <cmath>

#include "recording/column_map.hpp"
#include "recording/row_filter.hpp"
#include "support/input_error.hpp"
#include "support/units.hpp"

namespace fogcomp::cli {
namespace {

constexpr double kEarthRateDph = 15.041067;  // sidereal
constexpr double kRadiansPerDegree = kPi / 180;

}  // namespace

double RecordingOptions::earth_rate_dph() const {
  if (!latitude.given()) return 0;
  return axis.value() * kEarthRateDph * std::sin(latitude.value() * kRadiansPerDegree);
}

// --rate-column is the part of --columns for files with several axes.
std::string RecordingOptions::column_map() const {
  std::string map = columns.text();
  if (rate_column.given()) map += (map.empty() ? "rate=" : ",rate=") + rate_column.value();
  recording::parse_column_map(map);  // errors are reported before a file is read
  return map;
}

recording::ReadOptions RecordingOptions::value() const {
  recording::ReadOptions options;
  options.columns = column_map();
  options.scale_factor = scale_factor.find();
  options.where = where.text();
  recording::parse_row_choice(options.where);
  options.decimal_comma = decimal_mark.find();
  options.skip_bad_rows = skip_bad_rows.given();
  options.default_input_rate_dph = earth_rate_dph();
  options.stream_rate_hz = rate.find();
  options.is_table = table.given();
  options.temperature_degc = temperature.find();
  options.join = join.text();
  options.join_columns = join_columns.text();
  recording::parse_column_map(options.join_columns);
  return options;
}

recording::ReadOptions MaskedRecordingOptions::value(
    std::vector<std::string> runs, const std::vector<std::string>& holdouts) const {
  runs.insert(runs.end(), holdouts.begin(), holdouts.end());
  recording::ReadOptions options = RecordingOptions::value();
  for (const std::string& mask : masks.value()) {
    options.masks.push_back(recording::parse_mask(mask));
  }
  recording::require_masked_runs(options.masks, runs);
  for (const std::string& cut : cuts.value()) options.cuts.push_back(recording::parse_cut(cut));
  recording::require_cut_runs(options.cuts, runs);
  return options;
}

}  // namespace fogcomp::cli
