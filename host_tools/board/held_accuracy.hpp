#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace fogcomp::board {

/// Number of blocks, up to `hold_blocks`, for which a held drift is as good as the model: the drift
/// changes by no more than the fit's residual (rms) while the temperature passes through the
/// trained range, with soaks at its ends, at the fastest trained rate. All other inputs are
/// constant, an hour after power-on. A model without trained rates gets `hold_blocks`.
std::uint32_t accurate_hold_blocks(const model::Model& model, double block_s,
                                   std::uint32_t hold_blocks);

/// One part in how many of the sample rate may be wrong: so much that the drift is off by no more
/// than the fit's residual on the same way. From 50 (2 %: the RC oscillator of a demodulator is
/// good to 1 %) to 200 (0.5 %: the board measures over 10 s, and a sample may wait to be read).
std::uint32_t sample_rate_part(const model::Model& model, double block_s);

}  // namespace fogcomp::board
