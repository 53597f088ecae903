#include "board/verification_programme.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::board {
namespace {

constexpr double kRatesDegcPerMin[] = {0.2, 0.5, 1, 3, 10, 30};
constexpr double kSoakSeconds = 600;
constexpr int kJumps = 16;
constexpr double kLoopRateDegcPerMin = 3;
constexpr int kLoops = 5;

using Swing = fog::InputSwing;
constexpr Swing kRateDph{0, 20'000, 1900};
constexpr Swing kTableRateDph{0, 1'000'000'000, 1900};  // in every fourth period

double at(const Swing& swing, double time_s) {
  constexpr double kTwoPi = 6.283185307179586;
  return swing.middle_milli / 1000.0 +
         swing.amplitude_milli / 1000.0 * std::sin(kTwoPi * time_s / swing.period_s);
}

template <class Value>
Value nearest_value(double value) {
  return Value::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(value, Value::fractional_bits))));
}

class Programme {
 public:
  Programme(double low, double high, double block_s)
      : low_(low), high_(high), block_s_(block_s), temperature_(low) {}

  void ramp_to(double target, double rate_degc_per_min) {
    const double step = rate_degc_per_min / 60 * block_s_;
    while (temperature_ != target) {
      add();
      temperature_ += std::clamp(target - temperature_, -step, step);
    }
  }
  void soak() {
    for (double t = 0; t < kSoakSeconds; t += block_s_) add();
  }
  void jump_to(double share) { temperature_ = low_ + (high_ - low_) * share; }
  // Turning points that converge: each loop is inside the one before.
  void loops_about(double share) {
    const double centre = low_ + (high_ - low_) * share;
    for (int loop = kLoops; loop > 0; --loop) {
      const double half_range = (high_ - low_) / 4 * loop / kLoops;
      ramp_to(centre + half_range, kLoopRateDegcPerMin);
      ramp_to(centre - half_range, kLoopRateDegcPerMin);
    }
    soak();
  }
  void skip_years() {
    constexpr double kYears = 5;
    elapsed_ += static_cast<std::int32_t>(kYears * 365 * 86400 / std::max(block_s_, 1.0));
  }

  std::vector<fog::BlockMeans<fog::BoardNumbers>> blocks;

 private:
  void add() {
    const double time_s = static_cast<double>(blocks.size()) * block_s_;
    const bool on_table = std::fmod(time_s / kRateDph.period_s, 4) > 3;
    fog::BlockMeans<fog::BoardNumbers> block;
    block.temperature = nearest_value<fog::Temperature>(temperature_);
    block.input_rate = nearest_value<fog::Rate>(at(on_table ? kTableRateDph : kRateDph, time_s));
    block.elapsed = fog::Elapsed::from_raw(elapsed_++);
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      const fog::Input input = fog::extension_input(i);
      const double base = input == fog::Input::temperature2 ? temperature_ : 0;
      block[input] =
          nearest_value<fog::ExtensionValue>(base + at(description_of(input).swing, time_s));
    }
    blocks.push_back(block);
  }

  double low_;
  double high_;
  double block_s_;
  double temperature_;
  std::int32_t elapsed_ = 0;
};

}  // namespace

std::vector<fog::BlockMeans<fog::BoardNumbers>> verification_programme(fog::Temperature min,
                                                                       fog::Temperature max,
                                                                       double block_s) {
  const double low = std::ldexp(min.raw(), -fog::Temperature::fractional_bits);
  const double high = std::ldexp(max.raw(), -fog::Temperature::fractional_bits);
  Programme programme(low, high, block_s);
  for (const double rate : kRatesDegcPerMin) {
    programme.ramp_to(high, rate);
    programme.soak();
    programme.ramp_to(low, rate);
    programme.soak();
  }
  programme.skip_years();
  for (int i = 0; i < kJumps; ++i) {
    programme.jump_to(static_cast<double>((i * 7) % kJumps) / (kJumps - 1));
    programme.soak();
  }
  for (const double share : {0.25, 0.5, 0.75}) programme.loops_about(share);
  return std::move(programme.blocks);
}

}  // namespace fogcomp::board
