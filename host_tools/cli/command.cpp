#include "cli/command.hpp"

#include "support/text.hpp"

namespace fogcomp::cli {

const std::vector<Command>& all_commands() {
  static const std::vector<Command> commands{
      simulate_command(), info_command(),   denoise_command(), fit_command(),     compare_command(),
      diagnose_command(), add_command(),    history_command(), effects_command(), export_command(),
      stream_command(),   replay_command(), batch_command(),   paper_command()};
  return commands;
}

std::string help_text(const Command& command) {
  std::string text = "fogcomp " + command.name + " - " + command.summary + "\n\n";
  text += "usage: fogcomp " + command.name +
          (command.positionals.empty() ? "" : " " + command.positionals) + " [options]\n\n";
  for (const Option& option : command.options) {
    std::string left = (option.name.size() == 1 ? "-" : "--") + option.name;
    if (!option.value_name.empty()) left += " " + option.value_name;
    std::string right = option.help;
    if (!option.default_value.empty()) right += " [" + option.default_value + "]";
    text += format("  %-24s %s\n", left.c_str(), right.c_str());
  }
  text += "\nexample: " + command.example + "\n";
  return text;
}

}  // namespace fogcomp::cli
