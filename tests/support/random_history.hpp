#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/signal/quantities.hpp"
#include "core/thermal/block_means.hpp"

namespace fog::test {

/// Block means of a gyro's life out of soaks, ramps, steps and sensor noise, each drawn at random;
/// the other inputs change with each part.
class RandomHistory {
 public:
  RandomHistory(std::uint64_t seed, double min, double max)
      : random_(seed), min_(min), max_(max), temperature_(uniform(min, max)) {}

  BlockMeans<BoardNumbers> next() {
    if (left_-- <= 0) begin_part();
    temperature_ = std::clamp(temperature_ + per_block_, min_, max_);
    block_.temperature = fixed<Temperature>(temperature_ + noise_ * normal_(random_));
    gradient_ += (gradient_target_ - gradient_) / 200;
    set(Input::temperature2, temperature_ + gradient_);
    block_.elapsed = Elapsed::from_raw(elapsed_++);
    return block_;
  }

 private:
  void begin_part() {
    left_ = static_cast<int>(uniform(10, 1200));
    noise_ = uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.06);
    const double kind = uniform(0, 1);
    per_block_ = 0;
    if (kind < 0.5) per_block_ = uniform(-10, 10) / 60;
    if (kind > 0.9) temperature_ = uniform(min_, max_);
    gradient_target_ = uniform(-5, 5);
    // A rate table now and then, the Earth's rate otherwise.
    const double max_rate_dph = uniform(0, 1) < 0.2 ? 2e6 : 15;
    block_.input_rate = fixed<Rate>(uniform(-max_rate_dph, max_rate_dph));
    set(Input::magnetic, uniform(-500, 500));
    set(Input::light_power, uniform(0, 1) < 0.05 ? 0 : std::exp(uniform(-2, 9)));
    set(Input::supply, uniform(4, 6));
    set(Input::vibration, uniform(0, 1) < 0.5 ? 0 : uniform(0, 20));
  }
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }
  template <class Value>
  static Value fixed(double value) {
    return Value::from_raw(
        static_cast<std::int32_t>(std::lround(std::ldexp(value, Value::fractional_bits))));
  }
  void set(Input input, double value) { block_[input] = fixed<ExtensionValue>(value); }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double min_;
  double max_;
  double temperature_;
  double per_block_ = 0;
  double noise_ = 0;
  double gradient_ = 0;
  double gradient_target_ = 0;
  int left_ = 0;
  std::int32_t elapsed_ = 0;
  BlockMeans<BoardNumbers> block_;
};

}  // namespace fog::test
