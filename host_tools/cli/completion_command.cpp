// fogcomp completion: data for a shell to complete command lines, from the commands' descriptions.

#include <cstdio>

#include "cli/command.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// The part that is the same for all commands. A value may be a list, of which the last part is
// completed; "=" and ":" are separate words for bash, so a part contains neither.
constexpr const char* kFrame =
    R"(# bash completion for fogcomp, as `fogcomp completion bash` prints it.

_fogcomp_words() {
  local list=
  [[ $1 == *,* ]] && list=${1%%,*},
  mapfile -t COMPREPLY < <(compgen -P "$list" -W "$2" -- "${1##*,}")
}

_fogcomp() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} options= words=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    _fogcomp_words "$current" "%s help"
    return
  fi
  case ${COMP_WORDS[1]} in
%s  esac
  if [[ $current == -* ]]; then
    _fogcomp_words "$current" "$options --help"
    return
  fi
  [[ -n $words ]] && _fogcomp_words "$current" "$words"
  compopt -o filenames -o default
}

complete -F _fogcomp fogcomp
)";

// Patterns of bash: "--seed | --epochs".
std::string patterns(const std::vector<std::string>& names) {
  return join(names, " | ");
}

bool is_file(const Option& option) {
  return value_use(option) != ValueUse::word;
}

// The case of one command: its options and their possible values.
std::string arm(const Command& command) {
  std::vector<std::string> names;
  std::vector<std::string> free_values;  // options with any value
  std::string values;
  for (const Option* option : command.options()) {
    names.push_back(dashed(option->name));
    if (option->value_name.empty()) continue;
    if (!option->words.empty()) {
      values += "        " + names.back() + ")\n          _fogcomp_words \"$current\" \"" +
                join(option->words, " ") + "\"\n";
      values += is_file(*option) ? "          compopt -o default\n" : "";
      values += "          return\n          ;;\n";
    } else if (!is_file(*option)) {
      free_values.push_back(names.back());
    }
  }
  std::string text = "    " + command.name() + ")\n";
  text += "      options=\"" + join(names, " ") + "\"\n";
  if (!command.words.empty()) text += "      words=\"" + join(command.words, " ") + "\"\n";
  if (!free_values.empty()) values += "        " + patterns(free_values) + ") return ;;\n";
  if (!values.empty()) text += "      case $previous in\n" + values + "      esac\n";
  return text + "      ;;\n";
}

int print_completion(const std::string& shell) {
  if (shell != "bash") {
    throw InputError("fogcomp completion", "knows bash, not '" + shell + "'");
  }
  std::vector<std::string> names;
  std::string arms;
  for (const CommandPointer& command : all_commands()) {
    names.push_back(command->name());
    arms += arm(*command);
  }
  arms += "    help) words=\"" + join(names, " ") + "\" ;;\n";
  std::fputs(format(kFrame, join(names, " ").c_str(), arms.c_str()).c_str(), stdout);
  return 0;
}

struct CompletionCommand : Command {
  CompletionCommand()
      : Command("completion", {"bash", 1, 1}, "the completion script for bash",
                "source <(fogcomp completion bash)") {
    words = {"bash"};
  }
  int run() const override { return print_completion(arguments[0]); }
};

}  // namespace

CommandPointer completion_command() {
  return std::make_unique<CompletionCommand>();
}

}  // namespace fogcomp::cli
