#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/acquisition/reading_monitor.hpp"
#include "core/compensation/drift_model.hpp"
#include "core/effects/effect_check.hpp"
#include "core/effects/registry.hpp"
#include "core/expression/expression_program.hpp"
#include "core/signal/weighted_sum.hpp"
#include "core/thermal/filtered_derivative.hpp"
#include "core/thermal/thermal_state.hpp"
#include "proof/interval_numbers.hpp"

// The source of the effects and of the thermal state, run over intervals: all constants that the
// validator lets through, all signals that can reach them, all states. What no operation leaves
// here, it leaves on no board.

namespace {

using fog::proof::ConstantRange;
using fog::proof::Int128;
using fog::proof::IntervalNumbers;

using fog::proof::run;
using Constants = std::vector<ConstantRange>;

// Signals of any block. Temperatures are those that the monitor calls possible, the rate is that of
// a FilteredDerivative, which test ThermalState bounds, and all else may have any value.
fog::Signals<IntervalNumbers> any_signals() {
  fog::Signals<IntervalNumbers> signals;
  const auto temperature = [] {
    return IntervalNumbers::Temperature::within(fog::kMinTemperature.raw(),
                                                fog::kMaxTemperature.raw());
  };
  constexpr std::int32_t kMaxRate = fog::kMaxRateDegcPerMin
                                    << fog::TemperatureRate::fractional_bits;
  signals.temperature = temperature();
  signals.temperature_rate = IntervalNumbers::TemperatureRate::within(-kMaxRate, kMaxRate);
  signals.block.temperature = temperature();
  signals.block.input_rate = IntervalNumbers::Rate::any();
  signals.block.elapsed = IntervalNumbers::Elapsed::within(0, INT32_MAX);
  for (auto& value : signals.block.extension) value = IntervalNumbers::Number<16>::any();
  return signals;
}

// ---- Constants

template <class Effect>
bool valid(const std::vector<std::int32_t>& constants) {
  return Effect::constants_valid(constants.data());
}

// Cuts -2^31...2^31 - 1 so that each part ends below 9/8 of its beginning; small numbers are
// by themselves.
const std::vector<ConstantRange>& all_parts() {
  static const std::vector<ConstantRange> parts = [] {
    std::vector<ConstantRange> positive;
    for (std::int64_t low = 1; low <= INT32_MAX;) {
      const int octave = 63 - __builtin_clzll(static_cast<unsigned long long>(low));
      const std::int64_t next = low + (octave < 4 ? 1 : std::int64_t{1} << (octave - 3));
      positive.push_back({low, next - 1});
      low = next;
    }
    std::vector<ConstantRange> all{{0, 0}};
    for (const ConstantRange part : positive) {
      all.push_back(part);
      all.push_back({-part.high, -part.low});
    }
    all.push_back({INT32_MIN, INT32_MIN});
    return all;
  }();
  return parts;
}

// Ranges of constants that together hold all valid ones. `split`: number of the constant that is
// cut into parts; the others are one range each, whose ends are those of their valid parts.
template <class Effect>
class ValidConstants {
 public:
  static constexpr std::size_t kCount = Effect::constant_fractions.size();

  static std::vector<Constants> all() {
    std::vector<Constants> ranges{{}};
    for (std::size_t i = 0; i < kCount; ++i) {
      std::vector<Constants> longer;
      for (const Constants& before : ranges) {
        for (const ConstantRange part : parts_after(before)) {
          longer.push_back(before);
          longer.back().push_back(part);
        }
      }
      ranges = std::move(longer);
    }
    return ranges;
  }

 private:
  // The parts of the next constant with which some of its successors are valid. Of a constant whose
  // size matters for the others, or that is an integer, each; else those of one sign as one.
  static std::vector<ConstantRange> parts_after(const Constants& before) {
    std::vector<ConstantRange> parts;
    for (const ConstantRange part : all_parts()) {
      Constants with = before;
      with.push_back(part);
      if (may_be_valid(with)) parts.push_back(part);
    }
    if (parts.size() < 16 || (before.empty() && is_coupled())) return parts;
    std::vector<ConstantRange> signs;
    for (const int sign : {-1, 0, 1}) {
      const ConstantRange all = joined(parts, sign);
      if (all.low <= all.high) signs.push_back(all);
    }
    return signs;
  }
  // Two constants whose product is limited (scale_factor_asymmetry): the first one is cut.
  static bool is_coupled() {
    if constexpr (kCount == 2) {
      return valid<Effect>({1, INT32_MAX}) && valid<Effect>({INT32_MAX, 1}) &&
             !valid<Effect>({INT32_MAX, INT32_MAX});
    }
    return false;
  }
  static ConstantRange joined(const std::vector<ConstantRange>& parts, int sign) {
    ConstantRange all{INT64_MAX, INT64_MIN};
    for (const ConstantRange part : parts) {
      if ((part.low > 0) - (part.high < 0) != sign) continue;
      all.low = std::min(all.low, part.low);
      all.high = std::max(all.high, part.high);
    }
    return all;
  }
  // Whether a corner is valid, with 0, 1 or the largest value for the constants to come.
  static bool may_be_valid(const Constants& ranges) {
    std::vector<std::int32_t> corner(kCount);
    const auto try_from = [&](auto self, std::size_t i) -> bool {
      if (i == kCount) return valid<Effect>(corner);
      const auto given = i < ranges.size()
                             ? std::vector<std::int64_t>{ranges[i].low, ranges[i].high}
                             : std::vector<std::int64_t>{0, 1, INT32_MAX};
      for (const std::int64_t value : given) {
        corner[i] = static_cast<std::int32_t>(value);
        if (self(self, i + 1)) return true;
      }
      return false;
    };
    return try_from(try_from, 0);
  }
};

// What the cutting assumes of the validator: no valid constants are outside its ranges.
template <class Effect>
void expect_all_valid_within(const std::vector<Constants>& ranges) {
  std::mt19937_64 random(1);
  std::vector<std::int32_t> drawn(Effect::constant_fractions.size());
  for (int i = 0; i < 20000; ++i) {
    for (std::int32_t& value : drawn) {
      value = static_cast<std::int32_t>(static_cast<std::uint32_t>(random())) >> (random() % 32U);
    }
    if (!valid<Effect>(drawn)) continue;
    const bool within = std::any_of(ranges.begin(), ranges.end(), [&](const Constants& range) {
      for (std::size_t k = 0; k < drawn.size(); ++k) {
        if (drawn[k] < range[k].low || drawn[k] > range[k].high) return false;
      }
      return true;
    });
    ASSERT_TRUE(within) << "of " << Effect::description.name;
  }
}

// ---- Runs

using Trace = fog::proof::Run::Trace;  // low and high by turns

bool is_within(const Trace& trace, const Trace& other) {
  if (trace.size() != other.size()) return false;
  for (std::size_t i = 0; i < trace.size(); i += 2) {
    if (trace[i] < other[i] || trace[i + 1] > other[i + 1]) return false;
  }
  return true;
}

// Steps `subject` on all paths, then all that it has become, until each step's results are within
// those of an earlier step on the same path. Then nothing new can follow: narrower operands give
// narrower results, and a step makes its state anew.
template <class Subject, class Step>
void run_until_closed(const Subject& subject, Step step) {
  constexpr int kMaxSteps = 12;
  std::map<std::vector<bool>, std::vector<Trace>> seen;
  std::vector<Subject> last{subject};
  for (int steps = 1; !last.empty(); ++steps) {
    if (steps > kMaxSteps) return run().report("states that never close");
    std::vector<Subject> next;
    for (const Subject& before : last) {
      do {
        run().start_path();
        Subject after = before;
        step(after);
        const Trace trace = run().take_trace();
        std::vector<Trace>& earlier = seen[run().path()];
        const bool is_known = std::any_of(earlier.begin(), earlier.end(),
                                          [&](const Trace& one) { return is_within(trace, one); });
        if (run().excluded() || is_known) continue;
        earlier.push_back(trace);
        next.push_back(after);
      } while (run().next_path());
    }
    last.swap(next);
  }
}

// Each block may be the first one after a gap.
template <class Effect>
void run_block_effect(const Constants& constants) {
  run().start_path();
  Effect effect(constants.data());
  effect.reset(any_signals());
  run_until_closed(effect, [](Effect& subject) {
    const auto signals = any_signals();
    if (run().decide()) subject.reset(signals);
    std::array<IntervalNumbers::Regressor, Effect::coefficients.size()> regressors;
    subject.step(signals, regressors.data());
  });
}

// EffectBank::set() and at(): coefficients are any words, with kMinCoefficientFraction bits of
// fraction or more. Returns the largest drift.
template <class Effect>
Int128 run_rate_effect(const Constants& constants) {
  constexpr int kBits =
      31 + IntervalNumbers::Coefficient::fractional_bits - fog::kMinCoefficientFraction;
  constexpr Int128 kMax = Int128{1} << kBits;
  Int128 largest = 0;
  do {
    run().start_path();
    Effect effect(constants.data());
    std::array<IntervalNumbers::Coefficient, Effect::coefficients.size()> given;
    for (auto& value : given) value = IntervalNumbers::Coefficient::within(-kMax, kMax);
    effect.set(any_signals(), given.data());
    const auto drift = effect.at(IntervalNumbers::Rate::any());
    largest = std::max({largest, drift.high(), -drift.low()});
  } while (run().next_path());
  return largest;
}

struct Proof {
  std::string reports;        // empty: none
  Int128 drift_of_rates = 0;  // largest sum over the effects that follow the input rate

  friend Proof operator+(const Proof& a, const Proof& b) {
    return {a.reports + b.reports, a.drift_of_rates + b.drift_of_rates};
  }
};

template <class OnBoard, class OverIntervals>
Proof prove_on_board() {
  const auto ranges = ValidConstants<OnBoard>::all();
  expect_all_valid_within<OnBoard>(ranges);
  run() = fog::proof::Run();
  Proof proof;
  for (const Constants& constants : ranges) {
    if constexpr (fog::follows_input_rate(OnBoard::description.needs)) {
      proof.drift_of_rates =
          std::max(proof.drift_of_rates, run_rate_effect<OverIntervals>(constants));
    } else {
      run_block_effect<OverIntervals>(constants);
    }
  }
  for (const std::string& report : run().reports()) {
    proof.reports += std::string(OnBoard::description.name) + ": " + report + "\n";
  }
  return proof;
}

template <template <class> class Effect>
Proof prove() {
  using OnBoard = Effect<fog::BoardNumbers>;
  if constexpr (OnBoard::description.host_only == nullptr) {
    return prove_on_board<OnBoard, Effect<IntervalNumbers>>();
  } else {
    return {};
  }
}

template <template <class> class... Effects>
Proof prove_all(fog::EffectList<Effects...> /*list*/) {
  return (prove<Effects>() + ...);
}

TEST(Effects, NeverOverflowWhateverTableAndSignals) {
  const Proof proof = prove_all(fog::Registry{});
  EXPECT_EQ(proof.reports, "");
  EXPECT_LE(proof.drift_of_rates + fog::kMaxBlockDrift, INT64_MAX);
  EXPECT_GT(proof.drift_of_rates, Int128{1} << 61);  // it is there
}

TEST(ThermalState, NeverOverflowsWhateverTableAndBlocks) {
  run() = fog::proof::Run();
  fog::ThermalParameters<IntervalNumbers> parameters;
  parameters.derivative.decay = IntervalNumbers::Number<31>::within(1, INT32_MAX);
  parameters.derivative.rate_gain = IntervalNumbers::Number<24>::within(1, INT32_MAX);
  const auto possible =
      IntervalNumbers::Temperature::within(fog::kMinTemperature.raw(), fog::kMaxTemperature.raw());
  parameters.min = possible;
  parameters.max = possible;
  fog::ThermalState<IntervalNumbers> state(parameters);
  state.reset(any_signals().block);
  run_until_closed(state, [](fog::ThermalState<IntervalNumbers>& subject) {
    const auto signals = subject.step(any_signals().block);
    constexpr std::int32_t kMax = fog::kMaxRateDegcPerMin << fog::TemperatureRate::fractional_bits;
    EXPECT_LE(signals.temperature_rate.high(), kMax);
    EXPECT_GE(signals.temperature_rate.low(), -kMax);
    EXPECT_GE(signals.temperature.low(), fog::kMinTemperature.raw());
    EXPECT_LE(signals.temperature.high(), fog::kMaxTemperature.raw());
  });
  EXPECT_EQ(run().reports(), std::set<std::string>());
}

// The play of an expression: any value, clipped, and any radius that its check lets through.
TEST(Play, NeverOverflowsInAnExpression) {
  run() = fog::proof::Run();
  using Value = fog::Play<IntervalNumbers>::Value;
  const auto any_input = [] { return Value::within(-fog::kMaxPlayInput, fog::kMaxPlayInput); };
  fog::Play<IntervalNumbers> play(Value::within(0, fog::kMaxPlayRadius));
  play.start(any_input());
  run_until_closed(play, [&](fog::Play<IntervalNumbers>& subject) {
    const Value x = any_input();
    if (run().decide()) subject.start(x);
    subject.step(x);
  });
  EXPECT_EQ(run().reports(), std::set<std::string>());
}

// The lemma of FirstOrderLag<IntervalNumbers>, on the board's lag: its state is at most kExcess
// beyond the inputs so far, where it could leave them: at both ends and next to them.
TEST(FirstOrderLag, StaysWithinItsInputs) {
  using Lag = fog::FirstOrderLag<fog::BoardNumbers>;
  constexpr std::int64_t kExcess = fog::FirstOrderLag<IntervalNumbers>::kExcess;
  std::mt19937_64 random(1);
  std::int64_t worst = 0;
  for (int i = 0; i < 2'000'000; ++i) {
    const auto end = static_cast<std::int64_t>(random() >> (24U + random() % 16U));
    const std::int64_t sign = (i & 1) != 0 ? -1 : 1;
    // Beyond the end by up to kExcess, or short of it by any size.
    const std::int64_t off =
        kExcess - static_cast<std::int64_t>(random() >> (20U + random() % 44U));
    const auto decay = static_cast<std::int32_t>(random() >> (33U + random() % 31U));
    Lag lag(Lag::Decay::from_raw(decay));
    lag.reset(Lag::State::from_raw(sign * (end + off)));
    const auto after = lag.step(Lag::State::from_raw(sign * end)).raw();
    worst = std::max(worst, sign * after - end);
  }
  EXPECT_LE(worst, kExcess);
  EXPECT_GT(worst, kExcess / 2);
}

}  // namespace
