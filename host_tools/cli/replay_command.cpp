// fogcomp replay: the firmware's own code on this computer.

#include <cmath>
#include <cstdio>
#include <memory>

#include "board/board_source.hpp"
#include "board/replay.hpp"
#include "board/stream_source.hpp"
#include "cli/arguments.hpp"
#include "cli/board_header.hpp"
#include "cli/board_options.hpp"
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
  explicit Session(const Arguments& arguments)
      : run(arguments.positionals()[1]), board(arguments.positionals()[0]) {
    ReadOptions options = read_options(arguments);
    options.model_scale_factor = board.scale_factor();
    source = std::make_unique<StreamSource>(run, options, board.scale_factor(), board.needs());
  }

  std::string run;
  BoardSource board;
  std::unique_ptr<StreamSource> source;
};

int run_replay(const Arguments& arguments) {
  const std::string output_path = arguments.required("o");
  Session session(arguments);
  const StreamSource& source = *session.source;
  BoardSettings settings = board_settings(arguments);
  if (!arguments.has("sample-rate") && !source.is_capture() && source.period_s() > 0) {
    settings.sample_rate_hz = 1 / source.period_s();
  }
  const BoardTable& table = session.board.table(settings);
  const std::string& weights = arguments.positionals()[0];
  const fog::ModelParameters parameters = read_board_table(table, weights);
  // What export would refuse: no board will ever send it.
  if (const Model* model = session.board.model()) {
    verify_board(*model, parameters, weights, arguments.has(kAllowError));
  }
  if (!source.is_capture()) check_rate(parameters, source.period_s(), session.run);

  OutputFile output(output_path);
  Replay replay(parameters);
  source.send([&](fog::Span<const std::uint8_t> bytes, fog::SampleTime time) {
    const fog::Span<const std::uint8_t> frames = replay.feed(bytes, time);
    output.write(frames.data, frames.size);
  });
  const ReplaySummary& summary = replay.summary();
  if (summary.frames == 0) {
    throw InputError(session.run, "holds no good frame; is it a capture of the sensor stream?");
  }
  output.commit();
  if (arguments.has("json")) {
    Json result = Json::object();
    result.set("output", output_path).set("frames", static_cast<std::int64_t>(summary.frames));
    result.set("bytes", static_cast<std::int64_t>(summary.output_bytes));
    result.set("invalid_rates", static_cast<std::int64_t>(summary.invalid_rates));
    result.set("clamped_samples", static_cast<std::int64_t>(summary.clamped_samples));
    std::puts(result.text().c_str());
    return 0;
  }
  std::printf("%s: %s, %s; %s not valid, %s outside the trained range\n", output_path.c_str(),
              counted(summary.frames, "sample").c_str(),
              counted(summary.output_bytes, "byte").c_str(),
              counted(summary.invalid_rates, "rate").c_str(),
              counted(summary.clamped_samples, "sample").c_str());
  return 0;
}

int run_stream(const Arguments& arguments) {
  const std::string output_path = arguments.required("o");
  const Session session(arguments);
  OutputFile output(output_path);
  session.source->send([&](fog::Span<const std::uint8_t> bytes, fog::SampleTime) {
    output.write(bytes.data, bytes.size);
  });
  output.commit();
  if (!session.source->is_capture()) {
    std::printf("%s: %s\n", output_path.c_str(), counted(session.source->rows(), "sample").c_str());
  }
  return 0;
}

}  // namespace

Command replay_command() {
  Command command;
  command.name = "replay";
  command.positionals = "MODEL|HEADER RUN";
  command.least_positionals = command.most_positionals = 2;
  command.summary = "the firmware's own code here, byte for byte what the board sends";
  command.example = "fogcomp replay fog_model.h run.csv -o out.bin";
  command.options = {{"o", "OUT", "output stream to write", ""},
                     {"json", "", "one JSON object on stdout", ""}};
  for (Option& option : board_options()) command.options.push_back(std::move(option));
  add_recording_options(command);
  command.options.push_back({kAllowError,
                             "",
                             "replay a model even if its integers are too far off",
                             "",
                             false,
                             {},
                             true});
  command.needs = {{"o"}};
  command.run = run_replay;
  return command;
}

Command stream_command() {
  Command command;
  command.name = "stream";
  command.positionals = "MODEL|HEADER RUN";
  command.least_positionals = command.most_positionals = 2;
  command.summary = "the sensor stream in which a board would see a recording";
  command.example = "fogcomp stream fog_model.h run.csv -o in.bin";
  command.options = {{"o", "OUT", "sensor stream to write", ""}};
  add_recording_options(command);
  command.needs = {{"o"}};
  command.run = run_stream;
  return command;
}

}  // namespace fogcomp::cli
