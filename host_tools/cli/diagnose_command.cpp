// fogcomp diagnose: where and why a model fails.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/diagnosis_json.hpp"
#include "cli/diagnosis_text.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "report/diagnose_report.hpp"
#include "support/text.hpp"
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
  if (page.wanted()) {
    page.write(report::diagnose_report(found.ladder, loop_wanted, found.data, arguments));
  }
  if (json.given()) {
    const Json object =
        loop_wanted ? ladder_json(found.ladder) : diagnosis_json(found.ladder.first);
    std::puts(object.text().c_str());
    return 0;
  }
  const std::string runs = join(found.runs, " ");
  std::fputs(diagnosis_text(found.ladder.first, arguments[0], runs).c_str(), stdout);
  if (loop_wanted) std::fputs(ladder_text(found.ladder).c_str(), stdout);
  return 0;
}

}  // namespace

CommandPointer diagnose_command() {
  return std::make_unique<DiagnoseCommand>();
}

}  // namespace fogcomp::cli
