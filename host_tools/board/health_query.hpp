#pragma once

#include "board/board_port.hpp"
#include "core/frames/health_record.hpp"

namespace fogcomp::board {

/// Asks a board for its health record (firmware/SPEC.md), among the frames that it sends. Throws
/// InputError where no answer comes within `patience_s`; asks again every half second until then.
fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s);

}  // namespace fogcomp::board
