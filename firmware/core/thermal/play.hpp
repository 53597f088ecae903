#pragma once

#include "core/bytes/state_carrier.hpp"
#include "core/fixed_point/fixed.hpp"

namespace fog {

/// Play operator: follows x only when x has moved it by more than the radius. Rate-independent. At
/// constant x it does not change, so it cannot drift; clamping is exact, so no rounding
/// accumulates.
template <class N>
class Play {
 public:
  using Value = typename N::template Number<22>;  ///< +-512 degC

  explicit Play(Value radius) : radius_(radius) {}
  /// Before start(), of one whose radius was not known when it was made.
  void set_radius(Value radius) { radius_ = radius; }

  /// At power-on y is in the middle. After a gap, in which x may have gone anywhere, it is where
  /// the straight way would have left it: a coil's glue does not forget while nobody looks. How it
  /// came there is unknown in either case.
  void start(Value x) {
    const Value low = x - radius_;
    const Value high = x + radius_;
    y_ = is_new() ? x : clamp(y_, low, high);
    lowest_ = low;
    highest_ = high;
  }
  /// Takes x and returns x - y: within +-radius, the whole radius on the branches of a loop.
  Value step(Value x) {
    const Value low = x - radius_;
    const Value high = x + radius_;
    y_ = clamp(y_, low, high);
    lowest_ = clamp(lowest_, low, high);
    highest_ = clamp(highest_, low, high);
    return x - y_;
  }

  /// To be called before a step whose x may have come another way than it seems.
  void forget_history() {
    lowest_ = Value::lowest();
    highest_ = Value::highest();
  }

  /// Whether y no longer depends on its initial value: x has moved through twice the radius since.
  bool history_known() const { return lowest_ == highest_; }

  void carry(StateCarrier& state) {
    state(y_);
    state(lowest_);
    state(highest_);
  }

 private:
  bool is_new() const { return highest_ < lowest_; }

  Value radius_;
  Value y_{};
  Value lowest_ = from_integer<Value>(1);  // range of possible y; of a new one empty
  Value highest_{};
};

}  // namespace fog
