
#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "findings/json.hpp"
#include "workflow/recordings.hpp"

namespace fogcomp::cli {
namespace {

struct InfoCommand : Command {
  Number average{this,
                 {"average", "S", "length of a mean, seconds; at least a row of the file", "10"},
                 {1e-6, 1e6}};
  ReportOption report{this};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};
  GyroLimitOptions limits{this};

  InfoCommand()
      : Command("info", {"RUN", 1, 1},
                "segments, noise, Allan deviation, sensitivities of a recording",
                "fogcomp info run.csv --latitude 40 --axis up") {}
  int run() const override;
};

int InfoCommand::run() const {
  workflow::InfoRequest request{arguments.front(), recording.value(), average.find()};
  request.reading.limits = limits.value();
  ReportFile page(report);
  const workflow::InfoOutcome found = workflow::info(request, Watch().observer());
  findings::Document document =
      findings::info_findings(found.recording, found.summary, found.prospect);
  document.read_with(recording.given_words());
  page.fill(document);
  page.commit();
  print_found(
      json, [&] { return findings::info_json(found.recording, found.summary, found.prospect); },
      document, true);
  return 0;
}

}  // namespace

CommandPointer info_command() {
  return std::make_unique<InfoCommand>();
}

}  // namespace fogcomp::cli
