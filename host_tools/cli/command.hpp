#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/option.hpp"

namespace fogcomp::cli {

/// The words of a command line that are not options.
struct Positionals {
  std::string usage{};  ///< as shown in the usage line, e.g. "MODEL RUN..."
  std::size_t min = 0;
  std::size_t max = 0;
};
constexpr std::size_t kAnyNumber = 1000;

/// One `fogcomp COMMAND`: its options are its members. Help, completion and parser use them and the
/// following data.
class Command : public OptionGroup {
 public:
  virtual ~Command() = default;
  const std::string& name() const { return command(); }

  Positionals positionals;
  std::string purpose;                                ///< one line
  std::string example;                                ///< a working command line
  std::vector<const Option*> stand_for_positional{};  ///< options each of which replaces one
  const Option* further_models = nullptr;             ///< option for further models
  /// A required option; all missing ones are reported together.
  struct Need {
    const Option* option;
    std::vector<const Option*> unless{};  ///< others, each of which makes it unnecessary
    std::string proposal{};               ///< example value
  };
  std::vector<Need> needs;
  std::vector<std::string> words;  ///< positionals that are not files
  /// Whether it is one of these, such as an effect, perhaps with parameters.
  bool takes_word(const std::string& word) const;
  /// -o may name the first positional: a model may replace the original. Any other output that is
  /// an input is refused.
  bool may_replace_first = false;

  std::vector<std::string> arguments;  ///< the positionals that were given

  /// Returns the exit code: 0 done, 1 negative result. Bad input throws InputError (exit code 2).
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
CommandPointer calibrate_command();
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
CommandPointer plan_command();
CommandPointer replay_command();
CommandPointer simulate_command();
CommandPointer stream_command();
CommandPointer workbench_command();

/// Whether its positionals (except words) are files or folders to be read, judging by their names.
bool reads_positionals(const Command& command);

/// Whether a file is a model or a header that `export` wrote.
bool is_model_or_header(const std::string& path);

/// All commands, in the order of typical use.
std::vector<CommandPointer> all_commands();

/// The command of that name. Throws InputError with the nearest one.
CommandPointer find_command(const std::string& name);

/// Text of `fogcomp COMMAND --help`: one screen. `complete`: `fogcomp help COMMAND`, with all
/// options.
std::string help_text(const Command& command, bool complete);

/// Assigns the words after `fogcomp COMMAND` to the command's options and positionals. Throws
/// InputError for an unknown option (with the nearest one), a missing value, a wrong number or
/// order of positionals, a missing required option (together with missing inputs), an output that
/// is also an input, two outputs with one file, and a file name with a control character. Options
/// may be anywhere; `--name=value` and `--name value` both work.
void parse(Command& command, const std::vector<std::string>& words);

/// For an output that no option names: throws InputError if `path` is one of the inputs or outputs.
void check_output(const Command& command, const std::string& path);

}  // namespace fogcomp::cli
