#pragma once

#include <cstdint>
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
  /// Its values, as far as they can be listed: completion offers them, Arguments::choice() demands
  /// one of them.
  std::vector<std::string> words{};
  bool rare = false;  ///< in `fogcomp help COMMAND` and the manual, not in --help
};

/// What the value of an option is to the command.
enum class ValueUse : std::uint8_t {
  word,    ///< no file
  input,   ///< a file or folder that is read
  output,  ///< a file or folder that is written
};

/// By the name of the value, so that no command can forget to say it: "OUT...", and whatever -o
/// takes, is written; RUN, MODEL, FILE, HEADER, DIR are read. Arguments guards files by it, and
/// completion offers them.
ValueUse value_use(const Option& option);

/// The same options, left out of --help, which is to fit a screen.
std::vector<Option> rarely(std::vector<Option> options);

/// One `fogcomp COMMAND`: what its help, its completion and its parser are made from.
struct Command {
  std::string name;
  std::string positionals;  ///< as shown in the usage line, e.g. "MODEL RUN..."
  std::size_t least_positionals = 0;
  std::size_t most_positionals = 0;
  std::string stands_for_positional{};  ///< an option that takes the place of one, or ""
  std::string summary;                  ///< one line
  std::string example;                  ///< one command line that works
  std::vector<Option> options;
  /// Options that must be given; what is missing is said together.
  struct Need {
    std::string option;
    std::string unless{};    ///< another option, which makes it needless
    std::string proposal{};  ///< a value to try
  };
  std::vector<Need> needs{};
  std::vector<std::string> words{};  ///< positionals that are no files
  /// -o may name the first positional: a model replaces the one that it grew from. Any other output
  /// that is an input is refused.
  bool may_replace_first = false;
  /// Returns the exit code: 0 done, 1 the answer is no. Bad input throws InputError (exit code 2).
  int (*run)(const Arguments&) = nullptr;
};

constexpr std::size_t kAnyNumber = 1000;

Command add_command();
Command batch_command();
Command compare_command();
Command completion_command();
Command denoise_command();
Command diagnose_command();
Command effects_command();
Command export_command();
Command fit_command();
Command health_command();
Command history_command();
Command info_command();
Command man_command();
Command paper_command();
Command replay_command();
Command simulate_command();
Command stream_command();

/// Whether its positionals are files or folders that are read, but for its words: by their names.
bool reads_positionals(const Command& command);

/// Every command, in the order in which a user meets them.
const std::vector<Command>& all_commands();

/// The command of that name. Throws InputError naming the nearest.
const Command& find_command(const std::string& name);

/// "--name", "-o"
std::string dashed(const std::string& option_name);

/// What `fogcomp COMMAND --help` prints: a screen. `complete`: `fogcomp help COMMAND`, with every
/// option.
std::string help_text(const Command& command, bool complete);

}  // namespace fogcomp::cli
