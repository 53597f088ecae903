#include "workflow/replay.hpp"

#include <cmath>

#include "board/sensor_stream.hpp"
#include "board/table_files.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "workflow/export_header.hpp"

namespace fogcomp::workflow {
namespace {

// A header has its sample rate; a recording with another one would be replayed with wrong times.
void check_rate(const fog::ModelParameters& parameters, double period_s, const std::string& run) {
  const double board_s = parameters.acquisition.sample_period_us * 1e-6;
  constexpr double kTolerance = 0.01;
  if (period_s > 0 && std::abs(period_s / board_s - 1) > kTolerance) {
    throw InputError(run, format("is sampled at %.6g Hz but the header is for %.6g Hz; export it "
                                 "with --sample-rate %.6g",
                                 1 / period_s, 1 / board_s, 1 / period_s));
  }
}

board::StreamSource source_of(const StreamRequest& request, const board::BoardSource& board,
                              const Observer& observer) {
  recording::ReadOptions reading = observer.with_observer(request.reading);
  reading.model_scale_factor = board.scale_factor();
  if (board.model() != nullptr) {
    reading.model_columns = board.model()->columns;
    reading.model_decimal_comma = board.model()->decimal_comma;
  }
  return board::StreamSource(request.run, reading, board.scale_factor(), board.needs());
}

}  // namespace

std::optional<std::size_t> stream(const StreamRequest& request, const board::ByteSink& sink,
                                  const Observer& observer) {
  board::StreamSource source = source_of(request, board::BoardSource(request.weights), observer);
  source.send([&](fog::Span<const std::uint8_t> bytes, fog::SampleTime) { sink(bytes); });
  return source.is_capture() ? std::nullopt : std::optional(source.rows());
}

board::ReplaySummary run_board(const ReplayRequest& request, const BoardFeed& feed,
                               const Observer& observer) {
  board::BoardSource board(request.weights);
  board::StreamSource source = source_of(request, board, observer);
  board::BoardSettings settings = request.board;
  if (request.rate_of_recording && !source.is_capture() && source.period_s() > 0) {
    settings.sample_rate_hz = 1 / source.period_s();
  }
  const board::BoardTable& table = board.table(settings);
  const fog::ModelParameters parameters = board::read_board_table(table, request.weights);
  // Refuses what export refuses: no board can have it.
  if (const model::Model* model = board.model()) {
    verify_board(*model, parameters, request.weights, request.allow_error);
  }
  if (!source.is_capture()) check_rate(parameters, source.period_s(), request.run);

  board::Replay board_code(parameters);
  source.send([&](fog::Span<const std::uint8_t> bytes, fog::SampleTime time) {
    feed(board_code, source, bytes, time);
  });
  if (board_code.summary().frames == 0) {
    throw InputError(request.run, "holds no good frame; is it a capture of the sensor stream?");
  }
  return board_code.summary();
}

board::ReplaySummary replay(const ReplayRequest& request, const board::ByteSink& sink,
                            const Observer& observer) {
  return run_board(
      request,
      [&](board::Replay& board, const board::StreamSource&, fog::Span<const std::uint8_t> bytes,
          fog::SampleTime time) { sink(board.feed(bytes, time)); },
      observer);
}

}  // namespace fogcomp::workflow
