#include "simulation/chamber.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::simulation {
namespace {

// A common 1 m3 chamber.
constexpr double kAirTimeConstant_s = 120;
constexpr double kFastestAir_kps = 5.0 / 60;
constexpr double kFlutter_degc = 0.05;
constexpr double kFlutterTime_s = 60;
constexpr double kFan_grms = 0.02;
constexpr double kCompressor_grms = 0.05;
// The compressor runs below this temperature, and whenever the air has to cool.
constexpr double kCompressorBelow_degc = 15;
constexpr double kHeaterField_ut_per_kps = 600;
constexpr double kCompressorField_ut = 3;

}  // namespace

Chamber::Chamber(const Programme& programme, double step_s, std::uint64_t seed)
    : programme_(programme),
      step_s_(step_s),
      random_(seed, "chamber"),
      quiet_air_degc_(programme.start_degc) {
  state_.air_degc = programme.start_degc;
  state_.leg = &programme.legs.front();
  state_.vibration_grms = std::hypot(kFan_grms, state_.leg->conditions.vibration_grms);
}

double Chamber::set_point_degc(double time_s) {
  while (leg_ + 1 < programme_.legs.size() && time_s >= programme_.legs[leg_].end_s) ++leg_;
  const Leg& leg = programme_.legs[leg_];
  const double done = std::clamp((time_s - leg.start_s) / (leg.end_s - leg.start_s), 0.0, 1.0);
  return leg.from_degc + done * (leg.to_degc - leg.from_degc);
}

void Chamber::step() {
  state_.time_s = static_cast<double>(++steps_) * step_s_;
  const double wanted_degc = set_point_degc(state_.time_s);
  state_.leg = &programme_.legs[leg_];
  const double share = 1 - std::exp(-step_s_ / kAirTimeConstant_s);
  const double change_degc = std::clamp(share * (wanted_degc - quiet_air_degc_),
                                        -kFastestAir_kps * step_s_, kFastestAir_kps * step_s_);
  quiet_air_degc_ += change_degc;
  const double memory = std::exp(-step_s_ / kFlutterTime_s);
  flutter_degc_ =
      memory * flutter_degc_ + kFlutter_degc * std::sqrt(1 - memory * memory) * random_.gaussian();
  state_.air_degc = quiet_air_degc_ + flutter_degc_;

  const double rate_kps = change_degc / step_s_;
  const bool compressor_on = rate_kps < -1e-3 || quiet_air_degc_ < kCompressorBelow_degc;
  const Conditions& conditions = state_.leg->conditions;
  const double compressor_grms = compressor_on ? kCompressor_grms : 0;
  state_.vibration_grms = std::sqrt(kFan_grms * kFan_grms + compressor_grms * compressor_grms +
                                    conditions.vibration_grms * conditions.vibration_grms);
  state_.stray_field_ut =
      kHeaterField_ut_per_kps * std::max(rate_kps, 0.0) + (compressor_on ? kCompressorField_ut : 0);
}

}  // namespace fogcomp::simulation
