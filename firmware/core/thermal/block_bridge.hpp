#pragma once

#include <cstdint>

#include "core/bytes/state_carrier.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/thermal/block_means.hpp"

namespace fog {

/// Bridges blocks without valid data: the model is stepped once for each of them, with means on a
/// straight line from the last good block to the next one. So its lags have the right age, and a
/// steady ramp shows no trace of the gap. Used by board and host.
///
/// Means of inputs outside kPossible stay 0.
template <class N, InputMask kPossible = kAllInputs>
class BlockBridge {
 public:
  using Means = BlockMeans<N>;

  /// More than `hold_blocks` consecutive bad blocks are not bridged: too much may have happened
  /// meanwhile.
  explicit BlockBridge(std::uint32_t hold_blocks)
      : hold_blocks_(hold_blocks < kMaxBridged ? hold_blocks : kMaxBridged) {}

  /// The model has been started with `block`.
  void start(const Means& block) {
    last_stepped_ = block;
    remaining_ = 0;
  }

  /// Takes the next good block, after `missing` bad ones. Returns false if these are too many to
  /// bridge: then the model has to be started with `block`. The rest of an unfinished bridge
  /// becomes part of this one.
  bool bridge_to(const Means& block, std::uint32_t missing) {
    if (missing > hold_blocks_ || remaining_ > hold_blocks_ - missing) return false;
    target_ = block;
    remaining_ += missing + 1;
    return true;
  }

  /// Blocks with which the model still has to be stepped; the last one is the good one.
  std::uint32_t remaining() const { return remaining_; }

  /// The block with which the model was stepped last.
  const Means& last_stepped() const { return last_stepped_; }

  /// State when no block remains.
  void carry(StateCarrier& state) {
    state(last_stepped_.temperature);
    state(last_stepped_.elapsed);
    if constexpr (has(kPossible, Input::input_rate)) state(last_stepped_.input_rate);
    if constexpr ((kPossible & kAllExtensionInputs) != 0U) state(last_stepped_.extension);
  }

  /// Next block to step the model with. Requires remaining() > 0.
  const Means& next() {
    if (remaining_ == 1) {
      last_stepped_ = target_;
    } else {
      approach(last_stepped_.temperature, target_.temperature);
      approach(last_stepped_.elapsed, target_.elapsed);
      if constexpr (has(kPossible, Input::input_rate)) {
        approach(last_stepped_.input_rate, target_.input_rate);
      }
      for (std::size_t i = 0; i < kExtensionInputs; ++i) {
        if (!has(kPossible, extension_input(i))) continue;
        approach(last_stepped_.extension[i], target_.extension[i]);
      }
    }
    --remaining_;
    return last_stepped_;
  }

 private:
  static constexpr std::uint32_t kMaxBridged = INT32_MAX - 1;  // with the good block: INT32_MAX

  // Moves by one of remaining_ equal parts of the distance; the next parts absorb the rounding
  // error.
  template <class Value>
  void approach(Value& value, Value target) const {
    if constexpr (IsFixed<Value>::value) {
      const std::int32_t distance = saturating_difference(target.raw(), value.raw());
      value += Value::from_raw(distance / static_cast<std::int32_t>(remaining_));
    } else {
      value += (target - value) / remaining_;
    }
  }

  std::uint32_t hold_blocks_;
  std::uint32_t remaining_ = 0;  // at most hold_blocks_ + 1
  Means last_stepped_;           // the model has been stepped with it
  Means target_;
};

}  // namespace fog
