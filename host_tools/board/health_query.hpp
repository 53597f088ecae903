#pragma once

#include <optional>

#include "board/board_port.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

/// Asks a board for its health record (firmware/SPEC.md), among the frames that it sends. Throws
/// InputError where no answer comes within `patience_s`; asks again every half second until then.
fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s);

/// What lies in the slots of a board with the generic image; nothing where no answer comes within
/// `patience_s`, as from any other. Unless given it is asked twice.
std::optional<fog::SlotsRecord> query_slots(BoardPort& port, double patience_s = 0.75);

}  // namespace fogcomp::board
