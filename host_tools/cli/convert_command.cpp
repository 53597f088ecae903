// fogcomp convert: converts a recording of any layout to the plain format, and logs of other
// programs to a CSV.

#include <cstdio>
#include <filesystem>

#include "cli/command.hpp"
#include "cli/import_log.hpp"
#include "cli/recording_file.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "recording/csv_layout.hpp"
#include "recording/input_file.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "workflow/recordings.hpp"

namespace fogcomp::cli {
namespace {

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
