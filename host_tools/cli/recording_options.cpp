#include "cli/recording_options.hpp"

#include <cmath>
#include <cstdio>

#include "cli/arguments.hpp"
#include "support/input_error.hpp"
#include "support/units.hpp"

namespace fogcomp::cli {
namespace {

constexpr double kEarthRateDph = 15.041067;  // sidereal
constexpr double kRadiansPerDegree = kPi / 180;

double earth_rate_dph(const Arguments& arguments) {
  if (!arguments.has("latitude")) {
    if (arguments.has("axis")) {
      throw InputError("--axis", "means nothing without --latitude; give both");
    }
    return 0;
  }
  const double latitude_deg = arguments.number("latitude", -90, 90);
  const double up_dph = kEarthRateDph * std::sin(latitude_deg * kRadiansPerDegree);
  return arguments.choice("axis") == "up" ? up_dph : -up_dph;
}

}  // namespace

std::vector<Option> recording_options() {
  return {
      {"scale-factor", "C", "counts per deg/s of a `counts` column or a sensor stream", ""},
      {"skip-bad-rows", "", "leave bad rows out and count them instead of stopping", ""},
      {"latitude", "DEG", "subtract the Earth rate there, for a file without input_rate_dph", ""},
      {"axis",
       "up|down",
       "where the input axis points, with --latitude",
       "up",
       false,
       {"up", "down"}},
      {"rate", "HZ", "sample rate of a captured sensor stream", "200"},
  };
}

void add_recording_options(Command& command) {
  for (Option& option : recording_options()) command.options.push_back(std::move(option));
}

ReadOptions read_options(const Arguments& arguments) {
  ReadOptions options;
  if (arguments.has("scale-factor")) {
    options.scale_factor = arguments.number("scale-factor", 1e-6, 1e15);
  }
  options.skip_bad_rows = arguments.has("skip-bad-rows");
  options.default_input_rate_dph = earth_rate_dph(arguments);
  if (arguments.has("rate")) options.stream_rate_hz = arguments.number("rate", 1e-3, 1e6);
  return options;
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", note.c_str());
}

Option average_option() {
  return {"average", "S", "length of a block mean (a row where the rows are longer)", "10"};
}

double average_s(const Arguments& arguments) {
  return arguments.number("average", 1e-6, 1e6);
}

}  // namespace fogcomp::cli
