#pragma once

#include <functional>
#include <optional>
#include <string>

#include "board/board_table.hpp"
#include "board/replay.hpp"
#include "board/sensor_stream.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct StreamRequest {
  std::string weights;             ///< file of a model or an exported header
  std::string run;                 ///< recording
  recording::ReadOptions reading;  ///< model_scale_factor is replaced by that of the weights
};

/// Passes the sensor stream of a recording to `sink`, in pieces; a capture unchanged. Returns the
/// samples of a recording, nothing for a capture.
std::optional<std::size_t> stream(const StreamRequest& request, const board::ByteSink& sink,
                                  const Observer& observer = {});

struct ReplayRequest : StreamRequest {
  board::BoardSettings board;     ///< for a model; a header has its own
  bool rate_of_recording = true;  ///< overrides board.sample_rate_hz, if known
  bool allow_error = false;       ///< as in ExportRequest
};

/// Passes a piece of the sensor stream of `source` to the board's code.
using BoardFeed = std::function<void(board::Replay& board, const board::StreamSource& source,
                                     fog::Span<const std::uint8_t> bytes, fog::SampleTime time)>;

/// Runs the board's code over a run, piece by piece; throws InputError like replay().
board::ReplaySummary run_board(const ReplayRequest& request, const BoardFeed& feed,
                               const Observer& observer);

/// Passes the board's output to `sink`, in pieces. Throws InputError for what export_header()
/// refuses, for a header of another sample rate, and for a run without a good frame: then the data
/// in `sink` are invalid.
board::ReplaySummary replay(const ReplayRequest& request, const board::ByteSink& sink,
                            const Observer& observer = {});

}  // namespace fogcomp::workflow
