#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "report/report.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::cli {

/// What a page's workbench is about.
struct BenchInput {
  std::vector<std::string> runs;
  std::vector<std::string> holdouts{};
  std::vector<report::WorkbenchSetup::State> states{};
  /// Models that are in no file that a reader has: name and text; others are read.
  std::vector<report::WorkbenchSetup::File> made{};
};

/// With the recordings as they are or, where one is large, as means over 1 s. Throws InputError as
/// read_recording() does.
report::WorkbenchSetup bench_setup(const BenchInput& input, const RecordingOptions& recording,
                                   const workflow::Observer& observer);

/// The same for a report's page; nothing where this fogcomp has no engine, or where something
/// cannot be read a second time, as a pipe.
std::optional<report::WorkbenchSetup> report_bench(const BenchInput& input,
                                                   const RecordingOptions& recording);

/// A command as it was given, without `fogcomp` and what does not change the model.
std::vector<std::string> given_command(const Command& command);

}  // namespace fogcomp::cli
