#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"
#include "recording/recording.hpp"

namespace fogcomp::cli {

/// The options of all that read recordings: --scale-factor, --skip-bad-rows, --latitude, --axis,
/// --rate.
std::vector<Option> recording_options();
void add_recording_options(Command& command);

/// Their values. Throws InputError for a value out of range, or --axis without --latitude.
ReadOptions read_options(const Arguments& arguments);

/// Prints notes on what was read, a line each, on stderr.
void print_notes(const std::vector<std::string>& notes);

/// --average, in seconds.
Option average_option();
double average_s(const Arguments& arguments);

}  // namespace fogcomp::cli
