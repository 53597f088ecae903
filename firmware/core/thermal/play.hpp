#pragma once

#include "core/fixed_point/fixed.hpp"

namespace fog {

/// Play operator: follows x only when x has moved it by more than the radius. Rate-independent:
/// holds for ever at constant x, so it cannot drift; clamping is exact, so it cannot round away.
template <class N>
class Play {
 public:
  using Value = typename N::template Number<22>;  ///< +-512 degC

  explicit Play(Value radius) : radius_(radius) {}

  void centre(Value x) { y_ = x; }
  /// x - y after x: between - and + radius, the whole radius on the branches of a loop.
  Value step(Value x) {
    y_ = clamp(y_, x - radius_, x + radius_);
    return x - y_;
  }

 private:
  Value radius_;
  Value y_{};
};

}  // namespace fog
