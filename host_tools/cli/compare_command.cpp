// fogcomp compare: one or several models against measurements.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "findings/compare_findings.hpp"
#include "findings/json.hpp"
#include "report/terminal.hpp"
#include "workflow/compare.hpp"

namespace fogcomp::cli {
namespace {

struct CompareCommand : Command {
  Texts models{this, {"model", "MODEL", "a further model beside the first; may be repeated"}};
  Flag details{this, "details", "effects, dependences, Allan deviation, autocorrelation"};
  Number average{
      this,
      {"average", "S", "rows of the residual, seconds (default: as the first model was fitted)"},
      {1e-3, 1e6}};
  Choice<bool> network{this,
                       {"network", "on|off", "off shows the physical effects alone", "on"},
                       {{"on", true}, {"off", false}}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  CompareCommand()
      : Command("compare", {"MODEL RUN...", 2, kAnyNumber},
                "models against measurement: what is left, where, on what it depends",
                "fogcomp compare gyro.model run.csv --model other.model") {
    further_models = &models;
  }
  int run() const override;
};

int CompareCommand::run() const {
  ReportFile page(report);
  workflow::CompareRequest request;
  request.models = models.value();
  request.models.insert(request.models.begin(), arguments[0]);
  request.physics_alone = !network.value();
  request.average_s = average.find();
  request.reading = recording.value();
  request.runs = {arguments.begin() + 1, arguments.end()};
  const std::vector<compare::ModelOnRuns> judged = workflow::compare(request, Watch().observer());
  findings::Document document = findings::compare_findings(judged);
  document.read_with(recording.given_words());
  if (page.wanted()) page.write(document);
  if (json.given()) {
    std::puts(findings::compare_json(judged).text().c_str());
  } else {
    std::fputs(report::terminal(document, details.given()).c_str(), stdout);
  }
  return 0;
}

}  // namespace

CommandPointer compare_command() {
  return std::make_unique<CompareCommand>();
}

}  // namespace fogcomp::cli
