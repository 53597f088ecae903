#include "cli/import_log.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

constexpr std::size_t kHeadBytes = 1U << 16U;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OwnedFile = std::unique_ptr<std::FILE, CloseFile>;

// Installed, and in a build folder.
std::string script() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  for (const char* place : {"../share/fogcomp/importers", "importers"}) {
    const auto found = program.parent_path() / place / "import.mjs";
    if (std::filesystem::exists(found, error)) return std::filesystem::canonical(found);
  }
  throw InputError("fogcomp convert",
                   "its scripts share/fogcomp/importers are missing; install fogcomp again");
}

/// A program whose standard output is read here. Its errors go to `errors`.
class Child {
 public:
  /// Throws InputError, with `path`, if it cannot be started.
  Child(std::vector<std::string> words, int errors, const std::string& path) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError(path, std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int failed =
        ::posix_spawnp(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_.reset(::fdopen(ends[0], "r"));
    if (failed == 0) return;
    throw InputError(path, words.front() + ", which reads it, cannot be run (" +
                               std::strerror(failed) + "); install it: apt-get install nodejs npm");
  }
  ~Child() {
    output_.reset();  // a program that still writes ends by that
    if (process_ != 0) wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::FILE* output() const { return output_.get(); }
  // Whether it ended with exit code 0.
  bool wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t process_ = 0;
  OwnedFile output_;
};

// What the script says; before it there may be messages of the libraries that it uses.
std::string last_line(std::FILE* file) {
  std::string text;
  std::array<char, 4096> piece;
  std::rewind(file);
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), file)) {
    text.append(piece.data(), got);
  }
  const std::string_view lines = trim(text);
  return displayable(lines.substr(lines.rfind('\n') + 1));
}

}  // namespace

ImportedLog import_log(const Log& log, const std::string& output) {
  OutputFile file(output);
  const OwnedFile errors(std::tmpfile());
  if (!errors)
    throw InputError(log.path, std::string("no temporary file: ") + std::strerror(errno));
  Child node({"node", script(), log.importer, log.path, log.topic}, ::fileno(errors.get()),
             log.path);
  ImportedLog imported;
  std::size_t expected = 0;
  if (std::fscanf(node.output(), "%zu\n", &expected) != 1) expected = 0;
  Progress progress("reading " + log.path);
  std::array<char, kHeadBytes> piece;
  std::size_t lines = 0;
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), node.output())) {
    file.write(piece.data(), got);
    lines += static_cast<std::size_t>(std::count(piece.begin(), piece.begin() + got, '\n'));
    imported.head.append(piece.data(), std::min(got, kHeadBytes - imported.head.size()));
    progress.update(static_cast<double>(lines) / static_cast<double>(expected + 1));
  }
  const bool done = node.wait();
  imported.said = last_line(errors.get());
  if (!done) {
    throw InputError(log.path, imported.said.empty() ? "node, which reads it, was ended; try again"
                                                     : imported.said);
  }
  imported.rows = lines - 1;
  file.commit();
  return imported;
}

}  // namespace fogcomp::cli
