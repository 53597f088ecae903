// fogcomp man: the manual page, from the commands' descriptions.

#include <cstdio>

#include "cli/command.hpp"

namespace fogcomp::cli {
namespace {

// Escapes text for roff: no requests or escapes; dashes are ASCII.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '\\') {
      escaped += "\\e";
    } else if (character == '-') {
      escaped += "\\-";
    } else if (character == '\'') {
      escaped += "\\(aq";
    } else {
      escaped += character;
    }
  }
  return escaped.empty() || escaped[0] != '.' ? escaped : "\\&" + escaped;
}

std::string option_entry(const Option& option) {
  std::string text = ".TP\n\\fB" + roff(dashed(option.name)) + "\\fR";
  if (!option.value_name.empty()) text += " \\fI" + roff(option.value_name) + "\\fR";
  text += "\n" + roff(option.help);
  if (!option.default_value.empty()) text += " [" + roff(option.default_value) + "]";
  return text + "\n";
}

std::string command_section(const Command& command) {
  std::string text =
      ".SS \"fogcomp " + command.name() + " " + roff(command.positionals.usage) + "\"\n";
  text += roff(command.purpose) + ".\n";
  for (const Option* option : command.options()) text += option_entry(*option);
  return text + ".PP\nExample:\n.PP\n.nf\n    " + roff(command.example) + "\n.fi\n";
}

int print_manual() {
  std::string text =
      ".TH FOGCOMP 1 \"\" \"fogcomp " FOGCOMP_VERSION
      "\" \"User Commands\"\n"
      ".SH NAME\nfogcomp \\- finds and removes the temperature drift of a fibre\\-optic gyro\n"
      ".SH SYNOPSIS\n.B fogcomp\n\\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\n"
      "fogcomp learns a model of the drift from a recording in a thermal chamber, shows where the "
      "model fails and which physical effect is missing, and exports it for the gyro's board.\n"
      ".SH COMMANDS\n";
  for (const CommandPointer& command : all_commands()) text += command_section(*command);
  text +=
      ".SH EXIT STATUS\n0 done; 1 the answer is no; 2 bad arguments or input.\n"
      ".SH FILES\nFormats of recordings, models, limits and headers: host_tools/REFERENCE.md and "
      "firmware/SPEC.md of the source tree.\n"
      ".SH ENVIRONMENT\nNothing of it changes what fogcomp prints. Progress bars appear on "
      "terminals only.\n";
  std::fputs(text.c_str(), stdout);
  return 0;
}

struct ManCommand : Command {
  ManCommand()
      : Command("man", {}, "the manual page, with every option of every command",
                "fogcomp man | man -l -") {}
  int run() const override { return print_manual(); }
};

}  // namespace

CommandPointer man_command() {
  return std::make_unique<ManCommand>();
}

}  // namespace fogcomp::cli
