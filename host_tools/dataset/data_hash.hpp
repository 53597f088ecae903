#pragma once

#include <cstdint>

#include "dataset/recording.hpp"

namespace fogcomp {

/// All that a fit can depend on, as one number for the model's history: CRC-32 of the columns of a
/// recording, continued from `crc` (fog::kCrc32Initial for the first recording).
std::uint32_t data_hash(const Recording& recording, std::uint32_t crc);

}  // namespace fogcomp
