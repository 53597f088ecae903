#include "cli/command.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

constexpr std::size_t kLeftColumn = 22;
constexpr std::size_t kMaxColumns = 80;

// Wraps words to lines of at most kMaxColumns. The first line begins at `column`; the others are
// indented, and lines end with `end`.
std::string wrapped(const std::string& text, std::size_t column, std::size_t indent,
                    const std::string& end = "") {
  std::string lines;
  for (const std::string& word : split(text, ' ')) {
    if (column + word.size() + end.size() > kMaxColumns && column > indent) {
      lines.pop_back();
      lines += end + "\n" + std::string(indent, ' ');
      column = indent;
    }
    lines += word + " ";
    column += word.size() + 1;
  }
  if (!lines.empty()) lines.pop_back();
  return lines;
}

std::string option_text(const Option& option) {
  std::string left = "  " + dashed(option.name);
  if (!option.value_name.empty()) left += " " + option.value_name;
  std::string right = option.help;
  if (!option.default_value.empty()) right += " [" + option.default_value + "]";
  const std::size_t indent = kLeftColumn + 2;
  if (left.size() < indent) {
    left.resize(indent, ' ');
  } else {
    left += "\n" + std::string(indent, ' ');
  }
  return left + wrapped(right, indent, indent) + "\n";
}

}  // namespace

std::vector<CommandPointer> all_commands() {
  std::vector<CommandPointer> commands;
  for (CommandPointer (*make)() :
       {simulate_command, convert_command,    info_command,   denoise_command,   fit_command,
        compare_command,  diagnose_command,   add_command,    plan_command,      history_command,
        effects_command,  workbench_command,  apply_command,  export_command,    stream_command,
        replay_command,   load_command,       health_command, calibrate_command, batch_command,
        paper_command,    completion_command, man_command}) {
    commands.push_back(make());
  }
  return commands;
}

CommandPointer find_command(const std::string& name) {
  std::vector<std::string> names;
  for (CommandPointer& command : all_commands()) {
    if (command->name() == name) return std::move(command);
    names.push_back(command->name());
  }
  throw InputError("fogcomp", "no command '" + name + "'" + did_you_mean(name, names) +
                                  "; fogcomp --help lists them");
}

bool Command::takes_word(const std::string& word) const {
  return std::find(words.begin(), words.end(), word.substr(0, word.find(':'))) != words.end();
}

bool reads_positionals(const Command& command) {
  const auto names = [&](const char* file) {
    return command.positionals.usage.find(file) != std::string::npos;
  };
  return names("RUN") || names("MODEL") || names("DIR");
}

std::string help_text(const Command& command, bool complete) {
  std::string text = wrapped("fogcomp " + command.name() + " - " + command.purpose, 0, 4) + "\n\n";
  text += "usage: fogcomp " + command.name() +
          (command.positionals.usage.empty() ? "" : " " + command.positionals.usage) +
          " [options]\n\n";
  std::string further;
  for (const Option* option : command.options()) {
    if (complete || !option->rare) {
      text += option_text(*option);
    } else {
      further += " " + dashed(option->name);
    }
  }
  if (!further.empty()) {
    text += "  " + wrapped("more (fogcomp help " + command.name() + "):" + further, 2, 4) + "\n";
  }
  const std::string example = "example: ";
  text += "\n" + example + wrapped(command.example, example.size(), 4, " \\") + "\n";
  return text;
}

}  // namespace fogcomp::cli
