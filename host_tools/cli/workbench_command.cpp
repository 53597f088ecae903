// fogcomp workbench: the loop as an interactive page.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "cli/command.hpp"
#include "cli/page_rows.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "report/workbench_page.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

using report::WorkbenchSetup;

struct WorkbenchCommand : Command {
  Text output{this, {"o", "OUT.html", "the page"}};
  Texts holdouts{this, {"holdout", "RUN", "a run that judges; may be repeated"}};
  RecordingOptions recording{this};

  WorkbenchCommand()
      : Command("workbench", {"[MODEL] [RUN...]", 0, kAnyNumber},
                "the loop as a page that calculates: tick effects, see what is left",
                "fogcomp workbench gyro.model run.csv -o bench.html") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  WorkbenchSetup setup() const;
};

bool is_model(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kModelTitle.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kModelTitle;
}

bool is_too_large(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return !error && size > kMaxPageFile;
}

// The page has no folders.
std::string name_in_page(const WorkbenchSetup& setup, const std::string& path) {
  std::string name = path.substr(path.rfind('/') + 1);
  for (const WorkbenchSetup::File& other : setup.files) {
    if (other.name == name) {
      throw InputError(path, "has the name of another file of the page; give it another");
    }
  }
  return name;
}

// Means of the recording, and a sentence about them.
std::string shortened(WorkbenchSetup& setup, const std::string& path,
                      const recording::ReadOptions& reading) {
  const PageRows rows = page_rows(path, reading);
  setup.notes.push_back(
      format("%s has %zu rows, of which the page has the %zu means over 1 s: its figures are those "
             "of the command line to some digits only",
             path.c_str(), rows.samples, rows.rows));
  return rows.csv;
}

WorkbenchSetup WorkbenchCommand::setup() const {
  WorkbenchSetup setup;
  const workflow::Observer observer = on_stderr();
  const recording::ReadOptions reading = observer.with_observer(recording.value());
  std::vector<std::string> runs = arguments;
  if (!runs.empty() && is_model(runs[0])) {
    setup.model = name_in_page(setup, runs[0]);
    setup.files.push_back({setup.model, read_file(runs[0])});
    runs.erase(runs.begin());
  }
  if (runs.empty() && (holdouts.given() || !setup.model.empty())) {
    throw InputError("workbench", "has no recording to fit to; name it after the model");
  }
  const std::vector<std::string>& judges = holdouts.value();
  const bool shorten = std::any_of(runs.begin(), runs.end(), is_too_large) ||
                       std::any_of(judges.begin(), judges.end(), is_too_large);
  const auto add = [&](const std::string& path) {
    const std::string name = name_in_page(setup, path);
    setup.files.push_back({name, shorten ? shortened(setup, path, reading) : read_file(path)});
    return name;
  };
  for (const std::string& run : runs) setup.runs.push_back(add(run));
  for (const std::string& run : judges) setup.holdouts.push_back(add(run));
  // Means are written in the plain format.
  if (!shorten) setup.reading = recording.given_words();
  return setup;
}

int WorkbenchCommand::run() const {
  const std::string missing = report::why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  OutputFile page(output.required());
  const WorkbenchSetup begin = setup();
  for (const std::string& note : begin.notes) std::fprintf(stderr, "%s\n", note.c_str());
  page.write(report::workbench_page(begin));
  page.commit();
  std::printf("written: %s\n", output.value().c_str());
  return 0;
}

}  // namespace

CommandPointer workbench_command() {
  return std::make_unique<WorkbenchCommand>();
}

}  // namespace fogcomp::cli
