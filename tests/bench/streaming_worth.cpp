// Effect of the board's denoiser on noise and on real rotation at 200 Hz: the tables of
// firmware/FIGURES.md. `streaming_worth [MEMS.csv]` adds a real recording.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

#include "core/denoise/any_denoiser.hpp"
#include "denoise/denoise.hpp"
#include "noise/allan.hpp"
#include "recording/recording.hpp"
#include "support/sample_models.hpp"

namespace {

constexpr double kRateHz = 200;
constexpr double kTwoPi = 6.283185307179586;
// White noise of a sample, as expected by the table: 0.075 deg/h at 1 Hz.
const double kNoiseDph = 0.075 * std::sqrt(kRateHz);

using Denoiser = fog::Denoiser<fog::kAnyTaps, fog::kMaxLevels>;

std::vector<double> streamed(const std::vector<double>& input_dph, int levels,
                             fog::ThresholdRule rule = fog::ThresholdRule::heursure,
                             double noise_dph = kNoiseDph) {
  const auto table =
      fog::test::denoiser_table({"sym8", levels, rule, false}, noise_dph / std::sqrt(kRateHz));
  const auto denoiser =
      std::make_unique<Denoiser>(fogcomp::board::read_board_table(table, "bench").denoise);
  std::vector<double> output;
  for (const double rate_dph : input_dph) {
    const auto raw = static_cast<std::int32_t>(std::lround(rate_dph * 1024));
    output.push_back(denoiser->step(fog::Rate::from_raw(raw), true).rate.raw() / 1024.0);
  }
  return output;
}

std::vector<double> white_noise(std::size_t size) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, kNoiseDph);
  std::vector<double> values(size);
  for (double& value : values) value = normal(random);
  return values;
}

// Lengths in steps of four.
void print_allan(const char* title, const std::vector<double>& before,
                 const std::vector<double>& after, double period_s) {
  std::printf("\n%s\n%12s %14s %14s\n", title, "tau, s", "before, deg/h", "after, deg/h");
  const auto raw = fogcomp::noise::allan_deviation(before, {{0, before.size()}}, period_s);
  const auto denoised = fogcomp::noise::allan_deviation(after, {{0, after.size()}}, period_s);
  for (std::size_t i = 0; i < raw.size() && i < denoised.size(); i += 2) {
    std::printf("%12.3f %14.5f %14.5f\n", raw[i].tau_s, raw[i].sigma, denoised[i].sigma);
  }
}

// The sine of `frequency_hz` in `values`, after the start.
std::complex<double> component(const std::vector<double>& values, double frequency_hz,
                               std::size_t start) {
  const auto periods =
      std::floor(static_cast<double>(values.size() - start) * frequency_hz / kRateHz);
  const auto end = start + static_cast<std::size_t>(std::lround(periods * kRateHz / frequency_hz));
  std::complex<double> sum = 0;
  for (std::size_t i = start; i < end; ++i) {
    const double angle = kTwoPi * frequency_hz * static_cast<double>(i) / kRateHz;
    sum += values[i] * std::polar(1.0, -angle);
  }
  return sum * 2.0 / static_cast<double>(end - start);
}

std::size_t delay_of(int levels) {
  return fog::denoise_delay(16, static_cast<std::size_t>(levels));
}

// Noise of the output relative to that of the input.
double noise_left(int levels) {
  const std::vector<double> quiet = streamed(white_noise(100000), levels);
  double square = 0;
  for (std::size_t i = 20000; i < quiet.size(); ++i) square += quiet[i] * quiet[i];
  return std::sqrt(square / 80000) / kNoiseDph;
}

// Largest error of a step of 100 deg/s, deg/h.
double step_error(int levels) {
  std::vector<double> step(40000, 0.0);
  for (std::size_t i = 20000; i < step.size(); ++i) step[i] = 360000;
  const std::vector<double> stepped = streamed(step, levels, fog::ThresholdRule::fixed);
  double worst = 0;
  for (std::size_t i = delay_of(levels); i < step.size(); ++i) {
    worst = std::max(worst, std::abs(stepped[i] - step[i - delay_of(levels)]));
  }
  return worst;
}

// A sine in noise: what is left of it, as a fraction of what went in, its delay taken off.
std::complex<double> sine_left(int levels, double amplitude_dph, double frequency_hz) {
  const std::size_t delay = delay_of(levels);
  std::vector<double> input = white_noise(60000);
  for (std::size_t i = 0; i < input.size(); ++i) {
    input[i] += amplitude_dph * std::sin(kTwoPi * frequency_hz * static_cast<double>(i) / kRateHz);
  }
  const auto in = component(input, frequency_hz, 20000 - delay);
  std::vector<double> output = streamed(input, levels);
  output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(delay));
  return component(output, frequency_hz, 20000 - delay) / in;
}

void print_levels() {
  const double frequencies_hz[] = {0.1, 0.2, 0.5, 1, 2};
  std::printf(
      "noise of %.2f deg/h; error of a step of 100 deg/s, deg/h; amplitude of a sine of\n"
      "1 deg/h, out/in, and by how many ms its delay is off\n"
      "levels  delay, ms  noise out/in  step error",
      kNoiseDph);
  for (const double frequency_hz : frequencies_hz) std::printf("  %3.1f Hz", frequency_hz);
  std::printf("  off, ms\n");
  double min_large = 1;
  double max_large = 1;
  for (const int levels : {1, 2, 3, 4, 5, 6, 7}) {
    std::printf("%6d %10.0f %13.3f %11.2f", levels,
                1000 * static_cast<double>(delay_of(levels)) / kRateHz, noise_left(levels),
                step_error(levels));
    double max_off_ms = 0;
    for (const double frequency_hz : frequencies_hz) {
      const std::complex<double> left = sine_left(levels, 1, frequency_hz);
      std::printf("  %6.3f", std::abs(left));
      max_off_ms = std::max(max_off_ms, std::abs(1000 * std::arg(left) / (kTwoPi * frequency_hz)));
      const double large = std::abs(sine_left(levels, 3600, frequency_hz));
      min_large = std::min(min_large, large);
      max_large = std::max(max_large, large);
    }
    std::printf("  %7.2f\n", max_off_ms);
  }
  std::printf("sines of 3600 deg/h, out/in: %.4f to %.4f\n", min_large, max_large);
}

// White noise of a sample of a recording, independent of its drift.
double noise_of(const std::vector<double>& rate_dph) {
  std::vector<double> jumps;
  for (std::size_t i = 1; i < rate_dph.size(); ++i) {
    jumps.push_back(std::abs(rate_dph[i] - rate_dph[i - 1]));
  }
  std::nth_element(jumps.begin(), jumps.begin() + static_cast<std::ptrdiff_t>(jumps.size() / 2),
                   jumps.end());
  return jumps[jumps.size() / 2] / (0.6745 * std::sqrt(2));
}

void print_recording(const char* path) {
  const fogcomp::recording::Recording recording = fogcomp::recording::read_recording(path, {});
  const std::vector<double>& before = recording.rate_dph;
  std::vector<double> after = before;
  fogcomp::denoise::denoise({after.data(), after.size()}, {});
  print_allan("real MEMS gyro in a chamber, offline, sym8 x 5, heursure soft", before, after,
              recording.period_s);

  const double noise_dph = noise_of(before);
  std::vector<double> streaming = streamed(before, 5, fog::ThresholdRule::heursure, noise_dph);
  const std::size_t delay = fog::denoise_delay(16, 5);
  streaming.erase(streaming.begin(), streaming.begin() + static_cast<std::ptrdiff_t>(delay));
  print_allan("the same, streamed by the board's denoiser",
              {before.begin(), before.end() - static_cast<std::ptrdiff_t>(delay)}, streaming,
              recording.period_s);
  double max = 0;
  double mean = 0;
  for (std::size_t i = 0; i < streaming.size(); ++i) {
    max = std::max(max, std::abs(streaming[i] - before[i]));
    mean += (streaming[i] - before[i]) / static_cast<double>(streaming.size());
  }
  std::printf(
      "noise of a sample %.2f deg/h; %zu samples late; mean changed by %.4f, a sample by at "
      "most %.1f deg/h\n",
      noise_dph, delay, mean, max);
}

}  // namespace

int main(int argc, char** argv) {
  print_levels();
  const std::vector<double> noise = white_noise(400000);
  print_allan("white noise at 200 Hz, streamed, sym8 x 5, heursure soft", noise, streamed(noise, 5),
              1 / kRateHz);
  if (argc > 1) print_recording(argv[1]);
  return 0;
}
