// fogcomp workbench: the loop as one page that calculates.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "findings/text.hpp"
#include "report/workbench_page.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

struct WorkbenchCommand : Command {
  Text output{this, {"o", "OUT.html", "the page"}};
  Texts holdouts{this, {"holdout", "RUN", "a run that judges; may be repeated"}};
  RecordingOptions recording{this};

  WorkbenchCommand()
      : Command("workbench", {"[MODEL] [RUN...]", 0, kAnyNumber},
                "the loop as a page that calculates: tick an effect, see what it leaves",
                "fogcomp workbench gyro.model run.csv --holdout other.csv -o bench.html") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  report::WorkbenchSetup setup() const;
};

// Adds a file under a name of its own; in the page there are no folders.
std::string add_file(report::WorkbenchSetup& setup, const std::string& path,
                     const std::string& name) {
  for (const report::WorkbenchSetup::File& other : setup.files) {
    if (other.name == name) {
      throw InputError(path, "has the name of another file of the page; give it another");
    }
  }
  setup.files.push_back({name, read_file(path)});
  return name;
}

report::WorkbenchSetup WorkbenchCommand::setup() const {
  report::WorkbenchSetup setup;
  recording.value();  // what is wrong with the options is said before a file is read
  setup.reading = recording.given_words();
  const auto add = [&](const std::string& path) {
    return add_file(setup, path, path.substr(path.rfind('/') + 1));
  };
  for (const std::string& path : arguments) {
    const std::string name = add(path);
    const bool is_model = setup.files.back().bytes.rfind(kModelTitle, 0) == 0;
    if (is_model && setup.files.size() > 1) {
      throw InputError(path, "is a second model; a page begins with one");
    }
    if (is_model) {
      setup.model = name;
    } else {
      setup.runs.push_back(name);
    }
  }
  for (const std::string& path : holdouts.value()) setup.holdouts.push_back(add(path));
  if (setup.runs.empty() && !setup.files.empty()) {
    throw InputError("workbench", "has no recording to fit to; name one before --holdout");
  }
  return setup;
}

int WorkbenchCommand::run() const {
  const std::string missing = report::why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  OutputFile page(output.required());
  page.write(report::workbench_page(setup()));
  page.commit();
  std::printf("written: %s\n", output.value().c_str());
  return 0;
}

}  // namespace

CommandPointer workbench_command() {
  return std::make_unique<WorkbenchCommand>();
}

}  // namespace fogcomp::cli
