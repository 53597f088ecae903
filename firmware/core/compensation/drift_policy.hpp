#pragma once

#include <cstdint>

namespace fog {

/// Limits of how long the model may run without valid inputs, and its settling time.
struct DriftPolicy {
  std::uint32_t hold_blocks = 0;      ///< last drift is used for at most this many
  std::uint32_t accurate_blocks = 0;  ///< ... and is as good as the model for this many
  std::uint32_t settle_blocks = 0;    ///< time that the lags need after a (re)start
};

}  // namespace fog
