#pragma once

#include <cstdint>

#include "model/model.hpp"

namespace fogcomp::board {

/// For how many blocks, up to `hold_blocks`, a held drift is as good as the model: the drift
/// changes by no more than the residual that the fit left (rms) while the temperature goes through
/// the trained range, soaks at its ends included, as fast as it did in training. Time since
/// power-on stands still, an hour after it, and so do all other inputs. A model that does not know
/// how fast that was is taken to be good for `hold_blocks`.
std::uint32_t accurate_hold_blocks(const model::Model& model, double block_s,
                                   std::uint32_t hold_blocks);

}  // namespace fogcomp::board
