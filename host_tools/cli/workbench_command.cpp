// fogcomp workbench: the loop as an interactive page.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/page_bench.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "report/report.hpp"
#include "support/input_error.hpp"
#include "support/model_title.hpp"
#include "support/output_file.hpp"

namespace fogcomp::cli {
namespace {

struct WorkbenchCommand : Command {
  Text output{this, {"o", "OUT.html", "the page"}};
  Texts holdouts{this, {"holdout", "RUN", "a run that judges; may be repeated"}};
  RecordingOptions recording{this};

  WorkbenchCommand()
      : Command("workbench", {"[MODEL] [RUN...]", 0, kAnyNumber},
                "the loop as a page that calculates: tick effects, see the residual",
                "fogcomp workbench gyro.model run.csv -o bench.html") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  BenchInput input() const;
};

BenchInput WorkbenchCommand::input() const {
  BenchInput input{arguments, holdouts.value(), {}, {}};
  std::vector<std::string>& runs = input.runs;
  if (!runs.empty() && file_begins_with(runs[0], kModelTitle)) {
    input.states.push_back({runs[0], runs[0], {}, "", true});
    runs.erase(runs.begin());
  }
  if (runs.empty() && (holdouts.given() || !input.states.empty())) {
    throw InputError("workbench", "has no recording to fit to; name it after the model");
  }
  return input;
}

int WorkbenchCommand::run() const {
  const std::string missing = report::why_no_workbench();
  if (!missing.empty()) throw InputError("workbench", missing);
  OutputFile page(output.required());
  const report::WorkbenchSetup begin = bench_setup(input(), recording, on_stderr());
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
