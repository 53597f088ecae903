#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/frames/health_record.hpp"
#include "core/frames/slots_record.hpp"

namespace fogcomp::board {

/// Why a board must not be relied on now; empty if it may. `slots`: of a board with the generic
/// image.
std::vector<std::string> complaints(const fog::HealthRecord& record,
                                    const std::optional<fog::SlotsRecord>& slots);

}  // namespace fogcomp::board
