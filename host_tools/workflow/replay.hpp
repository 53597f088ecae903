#pragma once

#include <functional>
#include <optional>
#include <string>

#include "board/board_table.hpp"
#include "board/replay.hpp"
#include "board/sensor_stream.hpp"
#include "board/stream_source.hpp"
#include "recording/recording.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct StreamRequest {
  std::string weights;             ///< file of a model or an exported header
  std::string run;                 ///< recording
  recording::ReadOptions reading;  ///< model_scale_factor is the weights'
};

/// Hands the sensor stream in which a board would see the recording to `sink`, in pieces; a capture
/// as it is. Returns the samples of a recording, nothing for a capture.
std::optional<std::size_t> stream(const StreamRequest& request, const board::ByteSink& sink,
                                  const Observer& observer = {});

struct ReplayRequest : StreamRequest {
  board::BoardSettings board;     ///< for a model; a header has its own
  bool rate_of_recording = true;  ///< takes the place of board.sample_rate_hz, where known
  bool allow_error = false;       ///< as ExportRequest has it
};

/// Gives the board's code a piece of the sensor stream, which comes from `source`.
using BoardFeed = std::function<void(board::Replay& board, const board::StreamSource& source,
                                     fog::Span<const std::uint8_t> bytes, fog::SampleTime time)>;

/// Leads the board's code through a run, piece by piece; throws InputError as replay() does.
board::ReplaySummary run_board(const ReplayRequest& request, const BoardFeed& feed,
                               const Observer& observer);

/// Hands what the board would send to `sink`, in pieces. Throws InputError for what export_header()
/// would refuse, for a header of another sample rate, and for a run without a good frame: what
/// `sink` has got then counts for nothing.
board::ReplaySummary replay(const ReplayRequest& request, const board::ByteSink& sink,
                            const Observer& observer = {});

}  // namespace fogcomp::workflow
