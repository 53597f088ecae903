// fogcomp replay: the firmware's own code on this computer.

#include <cmath>
#include <cstdio>
#include <memory>

#include "board/board_source.hpp"
#include "board/replay.hpp"
#include "board/stream_source.hpp"
#include "cli/board_header.hpp"
#include "cli/board_options.hpp"
#include "cli/command.hpp"
#include "cli/recording_options.hpp"
#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

// A header knows its sample rate; a recording at another one would be replayed with wrong time.
void check_rate(const fog::ModelParameters& parameters, double period_s, const std::string& run) {
  const double board_s = parameters.acquisition.sample_period_us * 1e-6;
  constexpr double kTolerance = 0.01;
  if (period_s > 0 && std::abs(period_s / board_s - 1) > kTolerance) {
    throw InputError(run, format("is sampled at %.6g Hz but the header is for %.6g Hz; export it "
                                 "with --sample-rate %.6g",
                                 1 / period_s, 1 / board_s, 1 / period_s));
  }
}

// What `replay` and `stream` share: the weights, the recording, and the rate that joins them.
struct Session {
  Session(const Command& command, const RecordingOptions& recording)
      : run(command.arguments[1]), board(command.arguments[0]) {
    ReadOptions options = recording.value();
    options.model_scale_factor = board.scale_factor();
    source = std::make_unique<StreamSource>(run, options, board.scale_factor(), board.needs());
  }

  std::string run;
  BoardSource board;
  std::unique_ptr<StreamSource> source;
};

struct ReplayCommand : Command {
  Text output{this, {"o", "OUT", "output stream to write"}};
  Flag json{this, "json", "one JSON object on stdout"};
  BoardOptions board{this};
  RecordingOptions recording{this};
  AllowErrorFlag allow_error{this, "replay a model even if its integers are too far off", kRare};

  ReplayCommand()
      : Command("replay", {"MODEL|HEADER RUN", 2, 2},
                "the firmware's own code here, byte for byte what the board sends",
                "fogcomp replay fog_model.h run.csv -o out.bin") {
    needs = {{&output}};
  }
  int run() const override;

 private:
  void print(const ReplaySummary& summary) const;
};

void ReplayCommand::print(const ReplaySummary& summary) const {
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
  output.required();
  Session session(*this, recording);
  const StreamSource& source = *session.source;
  BoardSettings settings = board.value();
  if (!board.sample_rate.given() && !source.is_capture() && source.period_s() > 0) {
    settings.sample_rate_hz = 1 / source.period_s();
  }
  const BoardTable& table = session.board.table(settings);
  const std::string& weights = arguments[0];
  const fog::ModelParameters parameters = read_board_table(table, weights);
  // What export would refuse: no board will ever send it.
  if (const Model* model = session.board.model()) {
    verify_board(*model, parameters, weights, allow_error.given());
  }
  if (!source.is_capture()) check_rate(parameters, source.period_s(), session.run);

  OutputFile file(output.value());
  Replay replay(parameters);
  source.send([&](fog::Span<const std::uint8_t> bytes) {
    const fog::Span<const std::uint8_t> frames = replay.feed(bytes);
    file.write(frames.data, frames.size);
  });
  if (replay.summary().frames == 0) {
    throw InputError(session.run, "holds no good frame; is it a capture of the sensor stream?");
  }
  file.commit();
  print(replay.summary());
  return 0;
}

struct StreamCommand : Command {
  Text output{this, {"o", "OUT", "sensor stream to write"}};
  RecordingOptions recording{this};

  StreamCommand()
      : Command("stream", {"MODEL|HEADER RUN", 2, 2},
                "the sensor stream in which a board would see a recording",
                "fogcomp stream fog_model.h run.csv -o in.bin") {
    needs = {{&output}};
  }
  int run() const override;
};

int StreamCommand::run() const {
  output.required();
  const Session session(*this, recording);
  OutputFile file(output.value());
  session.source->send(
      [&](fog::Span<const std::uint8_t> bytes) { file.write(bytes.data, bytes.size); });
  file.commit();
  if (!session.source->is_capture()) {
    std::printf("%s: %s\n", output.value().c_str(),
                counted(session.source->rows(), "sample").c_str());
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
