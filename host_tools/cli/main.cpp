// fogcomp: finds the command, parses its words, runs it, and turns errors into one line and exit
// code 2.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "cli/axes.hpp"
#include "cli/command.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace {

using fogcomp::cli::all_commands;
using fogcomp::cli::CommandPointer;
using fogcomp::cli::find_command;

void print_overview() {
  std::puts("fogcomp - finds and removes the temperature drift of a fibre-optic gyro\n");
  std::puts("usage: fogcomp COMMAND [ARGUMENTS] (COMMAND --help: options; help COMMAND: all)\n");
  for (const CommandPointer& command : all_commands()) {
    std::printf("  %-10s %s\n", command->name().c_str(), command->purpose.c_str());
  }
  std::puts("\nexit codes: 0 done, 1 the answer is no, 2 bad arguments or input");
}

// Every call is checked before the first one runs.
int run_for_each_axis(const std::string& name, const std::vector<std::string>& words) {
  const std::vector<fogcomp::cli::AxisCall> calls = fogcomp::cli::axis_calls(words);
  std::vector<CommandPointer> commands;
  for (const auto& call : calls) {
    commands.push_back(find_command(name));
    fogcomp::cli::parse(*commands.back(), call.words);
  }
  fogcomp::cli::require_own_outputs(commands);
  fogcomp::cli::AxesReport report(calls, commands);
  int code = 0;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    if (!calls[i].axis.empty()) std::printf("%s%s\n", i == 0 ? "" : "\n", calls[i].axis.c_str());
    code = std::max(code, commands[i]->run());
  }
  report.finish();
  return code;
}

int run(const std::vector<std::string>& words) {
  const bool asks =
      !words.empty() && (words[0] == "--help" || words[0] == "-h" || words[0] == "help");
  if (asks && words.size() > 1) {
    std::fputs(fogcomp::cli::help_text(*find_command(words[1]), true).c_str(), stdout);
    return 0;
  }
  if (asks || words.empty()) {
    print_overview();
    return words.empty() ? 2 : 0;
  }
  if (words[0] == "--version") {
    std::puts("fogcomp " FOGCOMP_VERSION);
    return 0;
  }
  const CommandPointer command = find_command(words[0]);
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  const bool wants_help = std::any_of(rest.begin(), rest.end(), [](const std::string& word) {
    return word == "--help" || word == "-h";
  });
  if (wants_help) {
    std::fputs(fogcomp::cli::help_text(*command, false).c_str(), stdout);
    return 0;
  }
  return run_for_each_axis(words[0], rest);
}

}  // namespace

int main(int argc, char** argv) {
  // Above a file size limit (ulimit -f) a write fails, like on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = run(std::vector<std::string>(argv + 1, argv + argc));
    // An earlier failure leaves no data to flush, but sets the error flag.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw fogcomp::InputError("standard output",
                                "cannot be written completely; is the disk full?");
    }
    return code;
  } catch (const fogcomp::InputError& error) {
    std::fprintf(stderr, "%s\n", fogcomp::displayable(error.what()).c_str());
  } catch (const std::bad_alloc&) {
    std::fputs("fogcomp: out of memory; use a shorter recording or a machine with more\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fogcomp: internal error: %s\n", error.what());
  }
  return 2;
}
