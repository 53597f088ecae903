#pragma once

#include "cli/option.hpp"
#include "recording/recording.hpp"

namespace fogcomp::cli {

/// The options of all that read recordings.
struct RecordingOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  /// Throws InputError for a value out of range, or --axis without --latitude.
  recording::ReadOptions value() const;

  Number scale_factor{
      this,
      {"scale-factor", "C", "counts per deg/s of a `counts` column or a sensor stream"},
      {1e-6, 1e15}};
  Flag skip_bad_rows{this, "skip-bad-rows",
                     "leave bad rows out and count them instead of stopping"};
  Number latitude{
      this,
      {"latitude", "DEG", "subtract the Earth rate there, for a file without input_rate_dph"},
      {-90, 90}};
  Choice<double> axis{this,
                      {"axis", "up|down", "where the input axis points, with --latitude", "up"},
                      {{"up", 1}, {"down", -1}}};
  Number rate{this, {"rate", "HZ", "sample rate of a captured sensor stream", "200"}, {1e-3, 1e6}};

 private:
  double earth_rate_dph() const;
};

}  // namespace fogcomp::cli
