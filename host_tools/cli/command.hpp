#pragma once

#include <string>
#include <vector>

namespace fogcomp::cli {

class Arguments;

/// One option of a command. A flag has no value_name.
struct Option {
  std::string name;           ///< without the dashes; "o" is the short form of --output
  std::string value_name;     ///< shown in help, "" for a flag
  std::string help;           ///< one line
  std::string default_value;  ///< "" where there is none
  bool repeatable = false;    ///< may be given several times
};

/// One `fogcomp COMMAND`: what its help, its completion and its parser are made from.
struct Command {
  std::string name;
  std::string positionals;  ///< as shown in the usage line, e.g. "MODEL RUN..."
  std::size_t least_positionals = 0;
  std::size_t most_positionals = 0;
  std::string summary;  ///< one line
  std::string example;  ///< one command line that works
  std::vector<Option> options;
  /// Returns the exit code: 0 done, 1 the answer is no. Bad input throws InputError (exit code 2).
  int (*run)(const Arguments&) = nullptr;
};

constexpr std::size_t kAnyNumber = 1000;

Command add_command();
Command batch_command();
Command compare_command();
Command denoise_command();
Command diagnose_command();
Command effects_command();
Command export_command();
Command fit_command();
Command history_command();
Command info_command();
Command paper_command();
Command replay_command();
Command simulate_command();
Command stream_command();

/// Every command, in the order in which a user meets them.
const std::vector<Command>& all_commands();

/// The text of `fogcomp COMMAND --help`.
std::string help_text(const Command& command);

}  // namespace fogcomp::cli
