#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/option.hpp"

namespace fogcomp::cli {

/// The words of a command line that are no options.
struct Positionals {
  std::string usage{};  ///< as shown in the usage line, e.g. "MODEL RUN..."
  std::size_t min = 0;
  std::size_t max = 0;
};
constexpr std::size_t kAnyNumber = 1000;

/// One `fogcomp COMMAND`: its options are its members; help, completion and parser are made from
/// them and from what follows.
class Command : public OptionGroup {
 public:
  virtual ~Command() = default;
  const std::string& name() const { return command(); }

  Positionals positionals;
  std::string purpose;                            ///< one line
  std::string example;                            ///< one command line that works
  const Option* stands_for_positional = nullptr;  ///< an option that takes the place of one
  const Option* further_models = nullptr;         ///< where models beside the first belong
  /// Options that must be given; what is missing is said together.
  struct Need {
    const Option* option;
    const Option* unless = nullptr;  ///< another option, which makes it needless
    std::string proposal{};          ///< a value to try
  };
  std::vector<Need> needs;
  std::vector<std::string> words;  ///< positionals that are no files
  /// -o may name the first positional: a model replaces the one that it grew from. Any other output
  /// that is an input is refused.
  bool may_replace_first = false;

  std::vector<std::string> arguments;  ///< the positionals that were given

  /// Returns the exit code: 0 done, 1 the answer is no. Bad input throws InputError (exit code 2).
  virtual int run() const = 0;

 protected:
  Command(std::string name, Positionals takes, std::string one_line, std::string example_line)
      : OptionGroup(std::move(name)),
        positionals(std::move(takes)),
        purpose(std::move(one_line)),
        example(std::move(example_line)) {}
};

using CommandPointer = std::unique_ptr<Command>;
CommandPointer add_command();
CommandPointer apply_command();
CommandPointer batch_command();
CommandPointer compare_command();
CommandPointer completion_command();
CommandPointer convert_command();
CommandPointer denoise_command();
CommandPointer diagnose_command();
CommandPointer effects_command();
CommandPointer export_command();
CommandPointer fit_command();
CommandPointer health_command();
CommandPointer history_command();
CommandPointer info_command();
CommandPointer load_command();
CommandPointer man_command();
CommandPointer paper_command();
CommandPointer replay_command();
CommandPointer simulate_command();
CommandPointer stream_command();
CommandPointer workbench_command();

/// Whether its positionals are files or folders that are read, but for its words: by their names.
bool reads_positionals(const Command& command);

/// Every command, in the order in which a user meets them.
std::vector<CommandPointer> all_commands();

/// The command of that name. Throws InputError naming the nearest.
CommandPointer find_command(const std::string& name);

/// What `fogcomp COMMAND --help` prints: a screen. `complete`: `fogcomp help COMMAND`, with every
/// option.
std::string help_text(const Command& command, bool complete);

}  // namespace fogcomp::cli
