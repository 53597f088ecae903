#include "batch/gnu_parallel.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

std::string commands_path(const ParallelSettings& settings) {
  return settings.folder + "/commands.txt";
}

std::string log_path(const ParallelSettings& settings) {
  return settings.folder + "/jobs.txt";
}

std::string death_of(int exit_code, int signal, const ParallelSettings& settings) {
  constexpr int kTimedOut = -1;
  constexpr int kOfSignal = 128;  // a shell's exit code for it
  if (exit_code == kTimedOut) return format("took longer than %g s", settings.time_limit_s);
  if (signal == 0 && exit_code > kOfSignal) signal = exit_code - kOfSignal;
  if (signal > 0) return format("its process died of signal %d", signal);
  return exit_code > 1 ? format("its process exited with code %d", exit_code) : "";
}

}  // namespace

// --plain: whatever a user's own profile says.
std::string parallel_line(const ParallelSettings& settings) {
  std::vector<std::string> words{"parallel", "--plain", "--joblog", log_path(settings)};
  if (settings.jobs > 0) words.insert(words.end(), {"--jobs", std::to_string(settings.jobs)});
  if (settings.time_limit_s > 0) {
    words.insert(words.end(), {"--timeout", format("%g", settings.time_limit_s)});
  }
  if (::isatty(STDERR_FILENO) != 0) words.emplace_back("--bar");
  return shell_words(words) + " <" + shell_words({commands_path(settings)});
}

std::optional<std::vector<std::string>> run_parallel(const std::vector<std::string>& commands,
                                                     const ParallelSettings& settings) {
  write_file(commands_path(settings), join(commands, "\n") + "\n");
  std::filesystem::remove(log_path(settings));
  // The lines are quoted for a POSIX shell; whatever ends this process ends parallel.
  const int status = std::system(("PARALLEL_SHELL=/bin/sh exec setpriv --pdeathsig TERM " +
                                  parallel_line(settings) + " >/dev/null")
                                     .c_str());
  if (!std::filesystem::exists(log_path(settings))) {
    throw InputError("parallel",
                     "GNU parallel runs the gyros, and is not there; install it "
                     "(apt-get install parallel)");
  }
  constexpr int kInterrupted = 255;
  if (!WIFEXITED(status) || WEXITSTATUS(status) == kInterrupted) return std::nullopt;
  // A title line, then Seq (from 1), Host, Starttime, JobRuntime, Send, Receive, Exitval, Signal,
  // Command.
  std::vector<std::string> deaths(commands.size(), "was not run");
  for (const std::string& line : split(read_file(log_path(settings)), '\n')) {
    const std::vector<std::string> cells = split(line, '\t');
    if (cells.size() < 9 || cells[0] == "Seq") continue;
    deaths.at(std::stoul(cells[0]) - 1) =
        death_of(std::stoi(cells[6]), std::stoi(cells[7]), settings);
  }
  return deaths;
}

}  // namespace fogcomp::batch
