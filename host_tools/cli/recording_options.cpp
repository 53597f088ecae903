#include "cli/recording_options.hpp"

namespace fogcomp::cli {

void add_recording_options(Command& command) {
  command.options.push_back({"scale-factor", "COUNTS", "counts per deg/s", ""});
  command.options.push_back({"skip-bad-rows", "", "count bad rows instead of stopping", ""});
}
ReadOptions recording_options(const Arguments& arguments) {
  ReadOptions o;
  if (arguments.has("scale-factor")) o.scale_factor = arguments.number("scale-factor", 1e-6, 1e12);
  o.skip_bad_rows = arguments.has("skip-bad-rows");
  return o;
}

}  // namespace fogcomp::cli
