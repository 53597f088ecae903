#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kSecondsPerMs = 1e-3;

// The record at time t shows the table at t - delay; the true rotation is ahead by the delay. Only
// in sweeps; a step of the table falls between two of the simulator's steps.
class LateReference : public Effect {
 public:
  LateReference(const Parameters& parameters, const EffectContext&)
      : delay_s_(parameters["delay_ms"] * kSecondsPerMs) {}

  double step(const GyroState& state) override {
    const Conditions& table = state.chamber->leg->conditions;
    return table_rate_dph(table, state.time_s + delay_s_) - table_rate_dph(table, state.time_s);
  }

 private:
  double delay_s_;
};

}  // namespace

EffectDescription late_reference_effect() {
  return {
      "late_reference",
      "the table's record is late: a fault of the recording; needs a profile with a sweep",
      {peak_parameter(), scale_parameter(), {"delay_ms", "ms", 20, -1000, 1000, "of the record"}},
      make_effect<LateReference>};
}

}  // namespace fogcomp::simulation
