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

// Remaining amplitude and delay of a sine in noise, as a function of its amplitude.
void print_sines() {
  std::printf("\nsine in noise of %.2f deg/h: amplitude out / in\n%7s %9s %9s", kNoiseDph, "levels",
              "delay, ms", "in, deg/h");
  const double frequencies_hz[] = {0.1, 0.2, 0.5, 1, 2};
  for (const double frequency_hz : frequencies_hz) std::printf(" %7.1f Hz", frequency_hz);
  std::printf(" %15s\n", "delay off by, ms");
  const std::vector<double> noise = white_noise(60000);
  for (const int levels : {1, 2, 3, 4, 5, 6, 7}) {
    const std::size_t delay = fog::denoise_delay(16, static_cast<std::size_t>(levels));
    for (const double amplitude_dph : {1.0, 3600.0}) {
      std::printf("%7d %9.0f %9g", levels, 1000 * static_cast<double>(delay) / kRateHz,
                  amplitude_dph);
      double max_off_ms = 0;
      for (const double frequency_hz : frequencies_hz) {
        std::vector<double> input = noise;
        for (std::size_t i = 0; i < input.size(); ++i) {
          input[i] +=
              amplitude_dph * std::sin(kTwoPi * frequency_hz * static_cast<double>(i) / kRateHz);
        }
        const auto in = component(input, frequency_hz, 20000 - delay);
        std::vector<double> output = streamed(input, levels);
        output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(delay));
        const auto out = component(output, frequency_hz, 20000 - delay);
        std::printf(" %10.3f", std::abs(out) / std::abs(in));
        const double off_ms = 1000 * std::arg(out / in) / (kTwoPi * frequency_hz);
        max_off_ms = std::max(max_off_ms, std::abs(off_ms));
      }
      std::printf(" %15.2f\n", max_off_ms);
    }
  }
}

void print_noise_and_steps() {
  std::printf("\n%7s %9s %12s %20s\n", "levels", "delay, ms", "noise out/in",
              "step 100 deg/s, err");
  const std::vector<double> noise = white_noise(100000);
  for (const int levels : {1, 2, 3, 4, 5, 6, 7}) {
    const std::size_t delay = fog::denoise_delay(16, static_cast<std::size_t>(levels));
    const std::vector<double> quiet = streamed(noise, levels);
    double square = 0;
    for (std::size_t i = 20000; i < quiet.size(); ++i) square += quiet[i] * quiet[i];
    std::vector<double> step(40000, 0.0);
    for (std::size_t i = 20000; i < step.size(); ++i) step[i] = 360000;
    const std::vector<double> stepped = streamed(step, levels, fog::ThresholdRule::fixed);
    double worst = 0;
    for (std::size_t i = delay; i < step.size(); ++i) {
      worst = std::max(worst, std::abs(stepped[i] - step[i - delay]));
    }
    std::printf("%7d %9.0f %12.3f %14.2f deg/h\n", levels,
                1000 * static_cast<double>(delay) / kRateHz, std::sqrt(square / 80000) / kNoiseDph,
                worst);
  }
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
  print_noise_and_steps();
  print_sines();
  const std::vector<double> noise = white_noise(400000);
  print_allan("white noise at 200 Hz, streamed, sym8 x 5, heursure soft", noise, streamed(noise, 5),
              1 / kRateHz);
  if (argc > 1) print_recording(argv[1]);
  return 0;
}
