// fogcomp convert: converts a recording of any layout to the plain format.

#include <cstdio>

#include "cli/command.hpp"
#include "cli/recording_file.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "support/json.hpp"
#include "support/text.hpp"
#include "workflow/convert.hpp"

namespace fogcomp::cli {
namespace {

struct ConvertCommand : Command {
  Text output{this, {"o", "OUT", "recording to write: time_s,temperature_degc,rate_dph,..."}};
  Flag json{this, "json", "one JSON object on stdout"};
  RecordingOptions recording{this};

  ConvertCommand()
      : Command("convert", {"RUN", 1, 1},
                "any recording that is understood, as a CSV of the plain format",
                "fogcomp convert run.csv -o plain.csv") {
    needs = {{&output}};
  }
  int run() const override;
};

int ConvertCommand::run() const {
  output.required();
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
