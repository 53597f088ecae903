#pragma once

#include <cstdint>

#include "core/bytes/state_carrier.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/thermal/block_means.hpp"

namespace fog {

/// Leads a model through blocks that brought nothing: it is stepped once for each of them, with
/// means on a straight line from the last good block to the next one. So its lags have the age that
/// they should have, and a steady ramp leaves no trace of the gap. Board and host alike.
///
/// The means of inputs that are not in kPossible stay 0.
template <class N, InputMask kPossible = kAllInputs>
class BlockBridge {
 public:
  using Means = BlockMeans<N>;

  /// More than `hold_blocks` blocks in a row without a good one are not bridged: too much may have
  /// happened.
  explicit BlockBridge(std::uint32_t hold_blocks)
      : hold_blocks_(hold_blocks < kMaxBridged ? hold_blocks : kMaxBridged) {}

  /// The model has been started with this block.
  void start(const Means& block) {
    passed_ = block;
    left_ = 0;
  }

  /// The next good block, after `missing` without one. False where these are too many to bridge:
  /// then the model is to be started with it. What is left of a bridge that is not finished becomes
  /// part of this one.
  bool aim(const Means& block, std::uint32_t missing) {
    if (missing > hold_blocks_ || left_ > hold_blocks_ - missing) return false;
    target_ = block;
    left_ += missing + 1;
    return true;
  }

  /// Blocks that the model is still to be stepped with; the last one is the good one.
  std::uint32_t left() const { return left_; }

  /// The block that the model has been stepped with last.
  const Means& passed() const { return passed_; }

  /// Where no block is left.
  void carry(StateCarrier& state) {
    state(passed_.temperature);
    state(passed_.elapsed);
    if constexpr (has(kPossible, Input::input_rate)) state(passed_.input_rate);
    if constexpr ((kPossible & kAllExtensionInputs) != 0U) state(passed_.extension);
  }

  /// The next of them; not where none is left.
  const Means& next() {
    if (left_ == 1) {
      passed_ = target_;
    } else {
      approach(passed_.temperature, target_.temperature);
      approach(passed_.elapsed, target_.elapsed);
      if constexpr (has(kPossible, Input::input_rate)) {
        approach(passed_.input_rate, target_.input_rate);
      }
      for (std::size_t i = 0; i < kExtensionInputs; ++i) {
        if (!has(kPossible, extension_input(i))) continue;
        approach(passed_.extension[i], target_.extension[i]);
      }
    }
    --left_;
    return passed_;
  }

 private:
  static constexpr std::uint32_t kMaxBridged = INT32_MAX - 1;  // and the good one: an int32_t

  // One of left_ equal parts of the way; what rounding leaves is part of the next way.
  template <class Value>
  void approach(Value& value, Value target) const {
    if constexpr (IsFixed<Value>::value) {
      const std::int32_t way = saturating_difference(target.raw(), value.raw());
      value += Value::from_raw(way / static_cast<std::int32_t>(left_));
    } else {
      value += (target - value) / left_;
    }
  }

  std::uint32_t hold_blocks_;
  std::uint32_t left_ = 0;  // up to hold_blocks_ + 1
  Means passed_;            // the model has been stepped with it
  Means target_;
};

}  // namespace fog
