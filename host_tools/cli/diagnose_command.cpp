// fogcomp diagnose: where and why a model fails.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "findings/diagnose_findings.hpp"
#include "findings/json.hpp"
#include "report/terminal.hpp"
#include "workflow/diagnose.hpp"

namespace fogcomp::cli {
namespace {

struct DiagnoseCommand : Command {
  Texts expressions{this,
                    {"effect-expr", "EXPR",
                     "a candidate of your own beside the catalogue's, e.g. 'burst = T*T*dTdt'"}};
  Text at_rest{this, {"static", "RUN", "recording at rest: the noise is taken from there"}};
  Integer<int> max_effects{
      this,
      {"max-effects", "N", "add what is found, refit, look again, up to N times", "0"},
      0,
      12};
  Number average{this, {"average", "S", "rows, seconds (default: as fitted)"}, {1e-3, 1e6}};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of the draws that calibrate the test", "1"}, 0, INT64_MAX};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  DiagnoseCommand()
      : Command("diagnose", {"MODEL RUN...", 2, kAnyNumber},
                "where and why the model fails: which effect is missing",
                "fogcomp diagnose gyro.model run.csv --max-effects 4") {}
  int run() const override;

 private:
  workflow::DiagnoseRequest request() const;
};

workflow::DiagnoseRequest DiagnoseCommand::request() const {
  workflow::DiagnoseRequest request;
  request.model = arguments[0];
  request.average_s = average.find();
  request.max_effects = max_effects.value();
  request.seed = seed.value();
  request.reading = recording.value();
  request.expressions = expressions.value();
  request.runs = {arguments.begin() + 1, arguments.end()};
  request.at_rest = at_rest.find();
  return request;
}

int DiagnoseCommand::run() const {
  ReportFile page(report);
  const workflow::DiagnoseOutcome found = workflow::diagnose(request(), Watch().observer());
  const bool loop_wanted = max_effects.value() > 0;
  std::vector<std::string> files = found.runs;
  files.insert(files.begin(), arguments[0]);
  const findings::Document document =
      findings::diagnose_findings(found.ladder, found.next, loop_wanted, found.data, files);
  if (page.wanted()) page.write(document);
  if (json.given()) {
    const Json object = loop_wanted
                            ? findings::ladder_json(found.ladder, found.next, files)
                            : findings::diagnosis_json(found.ladder.first, found.next, files);
    std::puts(object.text().c_str());
  } else {
    std::fputs(report::terminal(document).c_str(), stdout);
  }
  return 0;
}

}  // namespace

CommandPointer diagnose_command() {
  return std::make_unique<DiagnoseCommand>();
}

}  // namespace fogcomp::cli
