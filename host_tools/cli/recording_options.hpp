#pragma once

#include <string>

#include "cli/option.hpp"
#include "recording/board_limits.hpp"
#include "recording/recording.hpp"

namespace fogcomp::cli {

/// The options of all commands that read recordings.
struct RecordingOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// Throws InputError for a value out of range.
  recording::ReadOptions value() const;

  Number scale_factor{
      this,
      {"scale-factor", "C", "counts per deg/s of a `counts` column or a sensor stream"},
      {1e-6, 1e15}};
  Text columns{this, {"columns", "MAP", "which is which: time=Stamp[ms],rate=Gyro_X[deg/s]"}};
  Text rate_column{this,
                   {"rate-column", "NAME",
                    "of several rates the one to take; x,y,z: each, % is its name", "", kRare}};
  Text where{this, {"where", "COLUMN=VALUE", "rows of one sensor: 'SensorId=1'", "", kRare}};
  Choice<bool> decimal_mark{
      this,
      {"decimal-mark", "point|comma", "of a CSV; the other mark parts thousands", "", kRare},
      {{"point", false}, {"comma", true}}};
  Flag skip_bad_rows{this, "skip-bad-rows",
                     "leave bad rows out and count them instead of stopping"};
  Number latitude{
      this, {"latitude", "DEG", "Earth rate to subtract, without input_rate_dph"}, {-90, 90}};
  Choice<double> axis{
      this,
      {"axis", "up|down", "where the input axis points, with --latitude", "up", kRare},
      {{"up", 1}, {"down", -1}}};
  Number rate{
      this, {"rate", "HZ", "rate of a stream or a CSV without true times", "200"}, {1e-3, 1e6}};
  Flag table{this, "table", "each line is a mean at a steady temperature, without a time", kRare};
  Number temperature{
      this,
      {"temperature", "DEGC", "of all samples of a file without temperatures", "", kRare},
      {-70, 130}};
  Text join{this, {"join", "FILE", "temperatures of the same times, from another CSV", "", kRare}};
  Text join_columns{
      this,
      {"join-columns", "MAP", "which is which in that: temperature=Sensor 2[degC]", "", kRare}};
  Clash without_latitude{this, {&axis}, Clash::When::without, &latitude};
  Clash table_has_no_rate{this, {&rate, &join}, Clash::When::with, &table};
  Clash without_join{this, {&join_columns}, Clash::When::without, &join};

 private:
  std::string column_map() const;
  double earth_rate_dph() const;
};

/// Limits of gyro and vehicle: for commands that make a calibration, and for those that read
/// recordings without a model.
struct GyroLimitOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  recording::GivenLimits value() const { return {range.find(), acceleration.find()}; }

  Number range{
      this,
      {"range-dps", "DPS", "full scale of the gyro (default: the model's, or 570)", "", kRare},
      {1e-3, recording::kMaxRangeDps}};
  Number acceleration{this,
                      {"max-acceleration", "DPS2",
                       "largest one, deg/s^2 (default: the model's, or 20000)", "", kRare},
                      {1e-3, 1e9}};
};

/// Additional options of the commands that fit and judge.
struct MaskedRecordingOptions : RecordingOptions {
  using RecordingOptions::RecordingOptions;
  /// Also throws InputError for a mask or a cut whose file is not among `runs` and `holdouts`.
  recording::ReadOptions value(std::vector<std::string> runs,
                               const std::vector<std::string>& holdouts = {}) const;

  Texts masks{this,
              {"mask", "FROM..TO",
               "s since power-on: rows that do not count; RUN:FROM..TO in one run", "", kRare}};
  Texts cuts{
      this,
      {"cut", "T", "s since power-on: the bias jumps; each part has its own; RUN:T in one run", "",
       kRare}};
  Clash table_has_no_times{this, {&masks, &cuts}, Clash::When::with, &table};
};

}  // namespace fogcomp::cli
