// Prints arguments and results of the functions that firmware/SPEC.md defines, one call a line.
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <vector>

#include "core/acquisition/sample_monitor.hpp"
#include "core/bytes/crc.hpp"
#include "core/denoise/denoiser.hpp"
#include "core/effects/effect_bank.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/sine.hpp"
#include "core/frames/delta_angle.hpp"
#include "core/frames/rate_float.hpp"
#include "core/network/drift_network.hpp"
#include "core/thermal/filtered_derivative.hpp"
#include "core/thermal/play.hpp"
#include "golden/spec_model.hpp"

namespace {

using Numbers = std::initializer_list<std::int64_t>;
using Q22 = fog::Fixed<std::int32_t, 22>;
using Q26 = fog::Fixed<std::int32_t, 26>;
using Q31 = fog::Fixed<std::int32_t, 31>;
using Signals = fog::Signals<fog::BoardNumbers>;

void line(const char* name, Numbers arguments, Numbers results) {
  std::printf("%s", name);
  for (const std::int64_t value : arguments) std::printf(" %" PRId64, value);
  std::printf(" ->");
  for (const std::int64_t value : results) std::printf(" %" PRId64, value);
  std::puts("");
}

class Random {
 public:
  std::int32_t word() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::int32_t>(state_ >> 32U);
  }
  /// Of every size.
  std::int32_t spread() {
    const std::int32_t value = word();
    return value >> (static_cast<std::uint32_t>(word()) >> 27U);
  }

 private:
  std::uint64_t state_ = 1;
};

void print_rounding(Random& random) {
  for (const std::int64_t x : {-5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5}) {
    line("round_shift", {x, 1}, {fog::round_shift(x, 1)});
    line("round_divide", {x, 2}, {fog::round_divide(x, 2)});
    line("round_divide", {x, 3}, {fog::round_divide(x, 3)});
  }
  for (int i = 0; i < 12; ++i) {
    const std::int64_t product = std::int64_t{random.spread()} * random.spread();
    line("round_shift", {product, 4 * i + 3}, {fog::round_shift(product, 4 * i + 3)});
    const std::int32_t divisor = (random.spread() & INT32_MAX) | 1;
    line("round_divide", {product / 2, divisor}, {fog::round_divide(product / 2, divisor)});
  }
  for (const std::int32_t x : {INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX}) {
    line("round_shift32", {x, 31}, {fog::round_shift(x, 31)});
  }
}

void print_elementary(Random& random) {
  std::vector<std::int32_t> arguments{INT32_MIN, -(1 << 27), -1,      0,        1,
                                      1 << 20,   1 << 26,    1 << 27, INT32_MAX};
  for (int i = 0; i < 24; ++i) arguments.push_back(random.spread());
  for (const std::int32_t x : arguments) {
    line("exponential", {x}, {fog::exponential_decay(Q26::from_raw(x)).raw()});
    const fog::SineCosine wave = fog::sine_cosine(static_cast<std::uint32_t>(x));
    line("sine_cosine", {static_cast<std::uint32_t>(x)}, {wave.sine.raw(), wave.cosine.raw()});
    const auto argument = fog::ActivationInput::from_raw(x);
    line("logistic", {x}, {fog::logistic(argument).raw()});
    line("tanh", {x}, {fog::hyperbolic_tangent(argument).raw()});
    const std::int64_t place = std::int64_t{x} * 321;
    line("activation", {place}, {fog::symmetric_logistic(fog::NodePlace::from_raw(place)).raw()});
    const std::int64_t positive = std::int64_t{x} * x / 7 + 1;
    line("logarithm", {positive, 16}, {fog::natural_logarithm(positive, 16).raw()});
    line("rate_float", {x}, {fog::rate_as_radians_float(fog::Rate::from_raw(x))});
  }
}

void print_crcs() {
  const std::array<std::uint8_t, 10> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9', 0xFF};
  for (std::size_t size = 0; size <= digits.size(); size += 3) {
    const auto count = static_cast<std::int64_t>(size);
    line("crc16", {count}, {fog::crc16(digits.data(), size)});
    line("crc32", {count}, {fog::crc32(digits.data(), size)});
  }
  line("crc16", {10}, {fog::crc16(digits.data(), 10)});
  line("crc32", {10}, {fog::crc32(digits.data(), 10)});
}

void print_delta_angle(Random& random) {
  fog::DeltaAngle angle(5000);
  for (const std::int32_t rate :
       {0, 1, 1, -1, 1024, 1024, -3000000, INT32_MAX, INT32_MIN, 5, 0, 0}) {
    angle.step(fog::Rate::from_raw(rate));
    line("delta_angle", {rate}, {angle.bits()});
  }
  for (int i = 0; i < 12; ++i) {
    const std::int32_t rate = random.spread();
    angle.step(fog::Rate::from_raw(rate));
    line("delta_angle", {rate}, {angle.bits()});
  }
}

void print_lags(Random& random) {
  constexpr std::int32_t kDecay = 70402888;
  fog::FirstOrderLag<fog::BoardNumbers> lag(Q31::from_raw(kDecay));
  lag.reset(fog::round_to<decltype(lag)::State>(fog::Temperature::from_raw(1310720)));
  fog::Play<fog::BoardNumbers> play(Q22::from_raw(3 << 22));
  play.start(Q22::from_raw(20 << 22));
  fog::FilteredDerivative<fog::BoardNumbers> derivative(
      {Q31::from_raw(kDecay), fog::Fixed<std::int32_t, 24>::from_raw(33001354)});
  derivative.reset(fog::Temperature::from_raw(1310720));
  for (int i = 0; i < 24; ++i) {
    const std::int32_t size = i < 12 ? 8 : 2;
    const auto x = fog::Temperature::from_raw(1310720 + (random.word() >> size) / 256);
    line("lag", {x.raw()}, {lag.step(fog::round_to<decltype(lag)::State>(x)).raw()});
    line("derivative", {x.raw()}, {derivative.step(x).raw()});
    const auto argument = fog::round_to<Q22>(x);
    const std::int32_t y = (argument - play.step(argument)).raw();
    line("play", {argument.raw()}, {y, play.history_known() ? 1 : 0});
  }
}

Signals signals_at(std::int32_t i) {
  constexpr std::int32_t kOne = 65536;
  Signals signals;
  signals.temperature = fog::Temperature::from_raw((i * 7 % 60 - 10) * kOne + i * 1234);
  signals.temperature_rate = fog::TemperatureRate::from_raw((i * 5 % 9 - 4) * 30000000 + i);
  signals.block.temperature = signals.temperature;
  signals.block.input_rate = fog::Rate::from_raw((i % 4 - 2) * 40000000 + i * 999);
  signals.block.elapsed = fog::Elapsed::from_raw(i * i * i);
  for (std::size_t n = 0; n < fog::kExtensionInputs; ++n) {
    signals.block.extension[n] =
        fog::ExtensionValue::from_raw((i % 5 + static_cast<int>(n)) * 300001);
  }
  return signals;
}

void print_signals(int count) {
  for (int i = 0; i < count; ++i) {
    const Signals signals = signals_at(i);
    const auto& extension = signals.block.extension;
    line("signals", {i},
         {signals.temperature.raw(), signals.temperature_rate.raw(), signals.block.elapsed.raw(),
          signals.block.input_rate.raw(), extension[0].raw(), extension[1].raw(),
          extension[2].raw(), extension[3].raw(), extension[4].raw()});
  }
}

// Each effect of the table alone.
void print_effects(int count) {
  for (const fog::test::SpecEffect& effect : fog::test::spec_effects()) {
    fog::EffectsParameters parameters;
    parameters.coefficient_fraction = 20;
    auto& given = parameters.by_id[static_cast<std::size_t>(effect.id)];
    if (!effect.constants.empty()) given.constants = effect.constants.data();
    given.coefficients = {effect.coefficients.data(), effect.coefficients.size()};
    fog::EffectBank<fog::kAllEffects> bank(parameters);
    bank.reset(signals_at(0));
    for (int i = 0; i < count; ++i) {
      const Signals signals = signals_at(i);
      const std::int64_t drift = bank.step(signals).raw();
      bank.set(signals);
      line("effect", {effect.id, i}, {drift, bank.at(signals.block.input_rate, {}).raw()});
    }
  }
}

fog::ModelParameters model_parameters(const std::vector<std::int32_t>& table) {
  fog::ModelParameters parameters;
  fog::read_model({table.data(), table.size()}, fog::kAnyModel, parameters);
  return parameters;
}

void print_programs(const std::vector<std::int32_t>& table, int count) {
  const fog::ModelParameters parameters = model_parameters(table);
  fog::ExpressionBank<fog::kAllExpressions> expressions(parameters.expressions, 20);
  fog::DriftNetwork<fog::kAllNetworkInputs> network(parameters.network);
  expressions.reset(signals_at(0));
  network.reset(signals_at(0));
  for (int i = 0; i < count; ++i) {
    const std::int64_t drift = expressions.step(signals_at(i)).raw();
    const auto& regressors = expressions.regressors();
    line("expressions", {i},
         {regressors[0].raw(), regressors[1].raw(), regressors[2].raw(), drift});
    line("network", {i}, {network.step(signals_at(i)).raw()});
  }
}

void print_denoiser(const char* name, fog::ThresholdRule rule, fog::ThresholdMode mode) {
  const std::vector<std::int32_t> filters = fog::test::spec_filters();
  const std::array<std::int32_t, 3> thresholds{150689, 106553, 75344};
  fog::DenoiseParameters parameters;
  parameters.filters = {filters.data(), filters.size()};
  parameters.thresholds = {thresholds.data(), thresholds.size()};
  parameters.rule = rule;
  parameters.mode = mode;
  line("noise_shift", {static_cast<int>(rule)}, {fog::noise_shift(parameters)});
  fog::Denoiser<4, 3> denoiser(parameters);
  Random random;
  for (int i = 0; i < 800; ++i) {
    std::int32_t rate = random.word() >> 21;
    if (i > 500) rate += (i % 64 < 32 ? 6000 : -6000);
    if (i % 71 == 70) rate += 40000;
    const bool valid = i > 1 && i % 150 != 149;
    const fog::DenoiserOutput output = denoiser.step(fog::Rate::from_raw(rate), valid);
    line(name, {i, rate, valid ? 1 : 0}, {output.rate.raw(), output.valid ? 1 : 0});
  }
}

void print_monitors() {
  fog::TemperatureMonitor monitor(200000, fog::kConfirmUs);
  Random random;
  std::int32_t temperature = 1310720;
  for (int i = 0; i < 500; ++i) {
    if (i < 100 || i > 450) temperature += 300 + (random.word() >> 25);
    if (i == 60) temperature += 400000;
    const std::int32_t reading = i == 40 ? temperature + 500000 : temperature;
    const std::uint32_t elapsed = i % 50 == 49 ? 3 : 1;
    const auto status = static_cast<std::uint32_t>(
        monitor.judge(fog::Temperature::from_raw(reading), i % 90 != 7, elapsed));
    line("reading", {reading, i % 90 != 7 ? 1 : 0, elapsed},
         {status, static_cast<int>(monitor.use()), monitor.confirmed() ? 1 : 0});
  }
}

void print_sequence() {
  fog::SequenceMonitor without(5000);
  fog::SequenceMonitor with(5000);
  struct Step {
    std::uint16_t number;
    std::uint32_t ms;
  };
  for (const Step step :
       {Step{65533, 0}, {65534, 5},       {65535, 10},      {0, 15},       {3, 30},
        {2, 35},        {3, 40},          {4, 45},          {4, 330'000},  {5, 330'005},
        {100, 330'010}, {40100, 330'015}, {40101, 330'020}, {1, 330'025},  {2, 330'030},
        {3, 330'035},   {4, 330'040},     {5, 330'045},     {6, 330'050},  {7, 330'055},
        {8, 330'060},   {9, 330'065},     {10, 330'070},    {41, 330'230}, {80, 330'430},
        {81, 330'435},  {82, 330'440}}) {
    const auto a = without.judge(step.number);
    const auto b = with.judge(step.number, {true, step.ms});
    line("sequence", {step.number, step.ms},
         {static_cast<std::uint32_t>(a.status), a.missing, a.late ? 1 : 0, a.doubtful ? 1 : 0,
          static_cast<std::uint32_t>(b.status), b.missing, b.late ? 1 : 0, b.doubtful ? 1 : 0});
  }
}

// Samples at the rate of the table, then 3 % too fast, then right again, then far too slow.
void print_sample_rate() {
  fog::SampleRateMonitor monitor(5000, 50);
  std::uint32_t us = 0;
  for (int i = 0; i < 400; ++i) {
    us += i < 120 ? 250'000 : i < 200 ? 242'500 : i < 330 ? 250'500 : 400'000;
    const std::uint32_t elapsed = i % 60 == 59 ? 0 : 50;
    const bool known = i % 150 != 149;
    const auto status = static_cast<std::uint32_t>(monitor.judge(elapsed, {known, us / 1000}));
    line("sample_rate", {elapsed, known ? std::int64_t{us / 1000} : -1}, {status});
  }
}

}  // namespace

int main() {
  std::puts(
      "# name arguments -> results, decimal. Effects, expressions and network: of the table of "
      "spec_stream.txt, each\n"
      "# alone, reset with signals 0, then stepped with signals 0, 1, 2... in turn.\n"
      "# signals i -> T' Tdot n W T2 B P V g (means: the same T, W). effect id i -> drift F 20, "
      "drift at W F 41.\n"
      "# expressions i -> regressors, drift. network i -> drift.\n"
      "# crc of so many bytes of 31 32 ... 39 FF. delta_angle: one after another, period 5000.\n"
      "# lag, derivative, play: one after another; decay 70402888, gain 33001354, radius 3 << 22, "
      "reset to 20 degC;\n"
      "# lag and derivative of x at F 16; lag -> y at F 40; play x -> y, whether its history is "
      "known.\n"
      "# denoise_*: i rate valid -> denoised, valid; filters as in spec_stream.txt, thresholds "
      "150689 106553 75344.\n"
      "# reading x valid elapsed -> flags, use (0 none, 1 good, 2 good anew), confirmed: the "
      "coil's, period 200000.\n"
      "# sequence number ms -> without a clock flags, missing, late, doubtful; with it the same; "
      "period "
      "5000.\n"
      "# sample_rate elapsed ms (-1: unknown) -> flag; elapsed 0: a late sample; period 5000.");
  constexpr int kBlocks = 24;
  Random random;
  print_rounding(random);
  print_elementary(random);
  print_crcs();
  print_delta_angle(random);
  print_lags(random);
  print_signals(kBlocks);
  print_effects(kBlocks);
  print_programs(fog::test::spec_table(), kBlocks);
  print_denoiser("denoise_fixed_hard", fog::ThresholdRule::fixed, fog::ThresholdMode::hard);
  print_denoiser("denoise_sqtwolog_soft", fog::ThresholdRule::sqtwolog, fog::ThresholdMode::soft);
  print_denoiser("denoise_heursure_soft", fog::ThresholdRule::heursure, fog::ThresholdMode::soft);
  print_monitors();
  print_sequence();
  print_sample_rate();
  return 0;
}
