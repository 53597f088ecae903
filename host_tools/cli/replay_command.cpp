// fogcomp replay: the firmware's own code on this computer.

#include <cstdio>

#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "cli/watch.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "workflow/replay.hpp"

namespace fogcomp::cli {
namespace {

board::ByteSink to(OutputFile& file) {
  return [&file](fog::Span<const std::uint8_t> bytes) { file.write(bytes.data, bytes.size); };
}

struct ReplayCommand : Command {
  Text output{this, {"o", "OUT", "output stream to write"}};
  Flag json{this, "json", "one JSON object on stdout"};
  BoardRunOptions run_options{this, "replay a model even if its integers differ too much"};

  ReplayCommand()
      : Command("replay", {"MODEL|HEADER RUN", 2, 2},
                "runs the firmware's code: the board's output, byte for byte",
                "fogcomp replay fog_model.h run.csv -o out.bin") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  void print(const board::ReplaySummary& summary) const;
};

void ReplayCommand::print(const board::ReplaySummary& summary) const {
  if (json.given()) {
    Json result = Json::object();
    result.set("output", output.value()).set("frames", static_cast<std::int64_t>(summary.frames));
    result.set("bytes", static_cast<std::int64_t>(summary.output_bytes));
    result.set("invalid_rates", static_cast<std::int64_t>(summary.invalid_rates));
    result.set("clamped_samples", static_cast<std::int64_t>(summary.clamped_samples));
    std::puts(result.text().c_str());
    return;
  }
  std::printf("%s: %s, %s; %s not valid, %s outside the trained range\n", output.value().c_str(),
              counted(summary.frames, "sample").c_str(),
              counted(summary.output_bytes, "byte").c_str(),
              counted(summary.invalid_rates, "rate").c_str(),
              counted(summary.clamped_samples, "sample").c_str());
}

int ReplayCommand::run() const {
  OutputFile file(output.required());
  const board::ReplaySummary seen =
      workflow::replay(run_options.value(arguments), to(file), Watch().observer());
  file.commit();
  print(seen);
  return 0;
}

struct StreamCommand : Command {
  Text output{this, {"o", "OUT", "sensor stream to write"}};
  RecordingOptions recording{this};

  StreamCommand()
      : Command("stream", {"MODEL|HEADER RUN", 2, 2},
                "a recording as the sensor stream that a board reads",
                "fogcomp stream fog_model.h run.csv -o in.bin") {
    needs = {{&output}};
  }
  int run() const override;
};

int StreamCommand::run() const {
  OutputFile file(output.required());
  const std::optional<std::size_t> samples = workflow::stream(
      {arguments[0], arguments[1], recording.value()}, to(file), Watch().observer());
  file.commit();
  if (samples) {
    std::printf("%s: %s\n", output.value().c_str(), counted(*samples, "sample").c_str());
  }
  return 0;
}

}  // namespace

CommandPointer replay_command() {
  return std::make_unique<ReplayCommand>();
}

CommandPointer stream_command() {
  return std::make_unique<StreamCommand>();
}

}  // namespace fogcomp::cli
