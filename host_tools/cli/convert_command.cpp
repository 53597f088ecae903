// fogcomp convert: converts a recording of any layout to the plain format, and logs of other
// programs to a CSV.

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

#include "cli/command.hpp"
#include "cli/recording_file.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "recording/csv_layout.hpp"
#include "recording/input_file.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"
#include "workflow/recordings.hpp"

namespace fogcomp::cli {
namespace {

// A log of another program, for a script of recording/importers.
struct Log {
  std::string importer;  // as importer_of() names it
  std::string path;
  std::string topic;  // "RATE" or "RATE,TEMPERATURE"; "": the only ones
};

struct ImportedLog {
  std::size_t rows = 0;
  std::string head;  // first bytes of the CSV
  std::string said;  // what was taken, in one line
};

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

// A program whose standard output is read here. Its errors go to `errors`.
class Child {
 public:
  // Throws InputError, with `path`, if it cannot be started.
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

// Writes a table of the log as CSV to `output`, completely or not at all: times, temperature if
// there is one, rates of the axes with their units. Runs node, with the scripts that lie beside
// this program. Throws InputError for a log that cannot be read, several topics of which none is
// chosen, and if node or the scripts or their packages are missing.
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

struct ConvertCommand : Command {
  Text output{this, {"o", "OUT", "recording to write: time_s,temperature_degc,rate_dph,..."}};
  Text topic{this,
             {"topic", "NAME", "of a log the topic to take; 'NAME,NAME': of rate and temperature"}};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  ConvertCommand()
      : Command("convert", {"RUN", 1, 1}, "converts a recording or a log to CSV",
                "fogcomp convert run.csv -o plain.csv") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  int convert_log(const std::string& importer) const;
};

// Of a log that a script reads its name, else "". A pipe, which can be read only once, is not
// looked at.
std::string importer_of_file(const std::string& path) {
  std::error_code error;
  const bool is_pipe =
      std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
  if (path == "-" || is_pipe) return "";
  return recording::importer_of(recording::InputFile(path).peek());
}

// The command that reads the CSV of a log; "" and the reason on stderr if there is more to say.
std::string next_command(const std::string& path, const std::string& head) {
  recording::ReadOptions options;
  std::vector<std::string> words{"fogcomp", "info", path};
  const std::string names = head.substr(0, head.find('\n'));
  if (names.find("rate_z [rad/s]") != std::string::npos) {
    options.columns = "rate=rate_z";
    words.insert(words.end(), {"--rate-column", "rate_z"});
    if (names.find("temperature_degc") == std::string::npos) {
      options.temperature_degc = 25;
      words.insert(words.end(), {"--temperature", "25"});
    }
  }
  try {
    recording::find_csv_layout({head, false, false, path}, options);
  } catch (const InputError& refusal) {
    std::fprintf(stderr, "%s\n", refusal.what());
    return "";
  }
  return shell_words(words);
}

int ConvertCommand::convert_log(const std::string& importer) const {
  const std::string& path = arguments.front();
  if (!recording.given_words().empty()) {
    throw InputError(
        recording.given_words().front(),
        "means nothing for " + path + "; give it to the command that reads " + output.value());
  }
  const ImportedLog log = import_log({importer, path, topic.text()}, output.value());
  std::fprintf(stderr, "%s: %s\n", path.c_str(), log.said.c_str());
  const std::string next = next_command(output.value(), log.head);
  if (json.given()) {
    Json result = Json::object();
    result.set("output", output.value()).set("rows", log.rows).set("next", next);
    std::puts(result.text().c_str());
    return 0;
  }
  std::printf("%s: %s\n", output.value().c_str(), counted(log.rows, "sample").c_str());
  if (!next.empty()) std::printf("  next: %s\n", next.c_str());
  return 0;
}

int ConvertCommand::run() const {
  output.required();
  const std::string importer = importer_of_file(arguments.front());
  if (!importer.empty()) return convert_log(importer);
  if (topic.given()) {
    throw InputError("--topic", "means nothing for " + arguments.front() + "; leave it out");
  }
  const recording::Recording found =
      workflow::convert({arguments.front(), recording.value()}, Watch().observer());
  write_recording(found, output.value());
  if (json.given()) {
    Json result = Json::object();
    result.set("output", output.value()).set("rows", found.rows());
    result.set("bad_rows", found.bad_rows).set("empty_rows", found.empty_rows);
    result.set("period_s", found.period_s);
    std::puts(result.text().c_str());
    return 0;
  }
  std::printf("%s: %s, %.4g s apart\n", output.value().c_str(),
              counted(found.rows(), "sample").c_str(), found.period_s);
  return 0;
}

}  // namespace

CommandPointer convert_command() {
  return std::make_unique<ConvertCommand>();
}

}  // namespace fogcomp::cli
