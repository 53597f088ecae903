#pragma once

#include <optional>

#include "board/board_port.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

/// Requests the health record of a board (firmware/SPEC.md), every half second. Throws InputError
/// if no answer comes within `patience_s`.
fog::HealthRecord query_health(BoardPort& port, const std::string& name, double patience_s);

/// Contents of the slots of a board with the generic image; nothing if no answer comes within
/// `patience_s`, as from any other image. The default time allows two requests.
std::optional<fog::SlotsRecord> query_slots(BoardPort& port, double patience_s = 0.75);

}  // namespace fogcomp::board
