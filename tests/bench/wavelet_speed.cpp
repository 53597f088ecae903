// Offline denoising of a whole recording: 16.5 h at 200 Hz, sym8 x 5. The column `per_sample` is
// the one to compare; run.sh prints what PyWavelets takes in the same run.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "denoise/denoise.hpp"
#include "denoise/filters.hpp"

namespace {

constexpr std::size_t kSamples = 11'900'000;

std::vector<double> recording() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> values(kSamples);
  for (double& value : values) value = normal(random);
  return values;
}

void report(benchmark::State& state) {
  state.counters["per_sample"] = benchmark::Counter(
      static_cast<double>(kSamples),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void transform_and_inverse(benchmark::State& state) {
  std::vector<double> values = recording();
  const std::vector<double>& sym8 = fogcomp::denoise::lowpass_filter("sym8");
  const auto pass = [&] {
    const auto parts = fogcomp::denoise::decompose({values.data(), values.size()}, sym8, 5);
    fogcomp::denoise::reconstruct(parts, sym8, {values.data(), values.size()});
  };
  pass();  // allocates memory, which is not to be measured
  for (auto _ : state) pass();
  report(state);
}

void denoise(benchmark::State& state, fogcomp::denoise::ThresholdRule rule) {
  const std::vector<double> noisy = recording();
  std::vector<double> values = noisy;
  fogcomp::denoise::DenoiseMethod method;
  method.rule = rule;
  fogcomp::denoise::denoise({values.data(), values.size()}, method);
  for (auto _ : state) {
    state.PauseTiming();
    values = noisy;
    state.ResumeTiming();
    fogcomp::denoise::denoise({values.data(), values.size()}, method);
  }
  report(state);
}

BENCHMARK(transform_and_inverse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(denoise, heursure, fogcomp::denoise::ThresholdRule::heursure)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(denoise, rigrsure, fogcomp::denoise::ThresholdRule::rigrsure)
    ->Unit(benchmark::kMillisecond);

}  // namespace
