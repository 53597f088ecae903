#pragma once

#include "core/bytes/state_carrier.hpp"
#include "core/fixed_point/fixed.hpp"

namespace fog {

/// tau dy/dt = x - y, stepped once per block: y += (x - y) * decay with decay = 1 -
/// exp(-block/tau), which is exact for an input that is constant within the block.
///
/// Formats: y has 40 fractional bits, x - y is rounded to 22 (clipped at +-512 degC), decay has 31.
/// y therefore follows until |x - y| < 2^-23 degC whatever tau is: for tau = 10^5 s and blocks of 1
/// s the smallest step, 2^-22 * 10^-5, is still 2.6 LSB of y. Bounds: |x - y| * decay < 2^31 *
/// 2^31.
template <class N>
class FirstOrderLag {
 public:
  using State = typename N::template Wide<40>;
  using Decay = typename N::template Number<31>;

  explicit FirstOrderLag(Decay decay) : decay_(decay) {}

  /// Starts in the steady state at x.
  void reset(State x) { y_ = x; }

  /// Advances by one block with input x and returns the new y.
  State step(State x) {
    const auto difference = saturate_to<typename N::template Number<22>>(x - y_);
    y_ += round_to<State>(difference * decay_);
    return y_;
  }

  State value() const { return y_; }

  void carry(StateCarrier& state) { state(y_); }

 private:
  Decay decay_;
  State y_{};
};

}  // namespace fog
