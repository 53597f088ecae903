#include "core/denoise/any_denoiser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/denoise/optional_denoiser.hpp"
#include "denoise/filters.hpp"
#include "support/overflow_guard.hpp"
#include "support/removal_bound.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::Rate;
using fog::test::kNoiseResolution;
using Denoiser = fog::Denoiser<fog::kAnyTaps, fog::kMaxLevels>;

constexpr std::size_t kDelay = 465;

// A bank with the same threshold on every level, sym8 x 5 unless said otherwise.
class DenoiserTest : public testing::Test {
 protected:
  std::unique_ptr<Denoiser> make(double threshold_dph, fog::ThresholdMode mode,
                                 const std::string& wavelet = "sym8", int levels = 5,
                                 fog::ThresholdRule rule = fog::ThresholdRule::fixed) {
    filter_ = fogcomp::denoise::lowpass_filter(wavelet);
    table_ = fog::test::denoiser_table({wavelet, levels, rule, false});
    fog::DenoiseParameters parameters = fogcomp::board::read_board_table(table_, "test").denoise;
    const auto raw = static_cast<std::int32_t>(std::lround(std::ldexp(threshold_dph, 16)));
    thresholds_.assign(static_cast<std::size_t>(levels), raw);
    parameters.thresholds = {thresholds_.data(), thresholds_.size()};
    parameters.mode = mode;
    EXPECT_GE(fog::noise_shift(parameters), 0);
    return std::make_unique<Denoiser>(parameters);
  }
  static std::vector<std::int32_t> run(Denoiser& denoiser, const std::vector<std::int32_t>& input) {
    std::vector<std::int32_t> output;
    for (const std::int32_t raw : input) {
      output.push_back(denoiser.step(Rate::from_raw(raw), true).rate.raw());
    }
    return output;
  }
  std::vector<std::int32_t> random_input(std::size_t size, std::int32_t largest) {
    std::vector<std::int32_t> values(size);
    std::uniform_int_distribution<std::int32_t> uniform(-largest, largest);
    for (std::int32_t& value : values) value = uniform(random_);
    return values;
  }

  std::mt19937 random_{1};
  fogcomp::board::BoardTable table_;
  std::vector<double> filter_;
  std::vector<std::int32_t> thresholds_;
};

// With the same threshold on every level.
double removal_bound(const std::vector<double>& low, int levels) {
  const std::vector<double> bounds = fog::test::removal_bounds(low, levels);
  return std::accumulate(bounds.begin(), bounds.end(), 0.0);
}

TEST_F(DenoiserTest, WithThresholdZeroIsTheInputDelayedBy465SamplesBitForBit) {
  const auto denoiser = make(0, fog::ThresholdMode::soft);
  EXPECT_EQ(denoiser->delay(), kDelay);
  const auto input = random_input(5000, INT32_MAX);
  const auto output = run(*denoiser, input);
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ(output[i], i < kDelay ? input[0] : input[i - kDelay]) << i;
  }
}

// The firmware's form, delayed input - synthesis(removed part), equals the textbook form: analysis,
// soft threshold, synthesis in double, with the whole tree.
std::vector<double> textbook(const std::vector<double>& input, const std::vector<double>& h,
                             std::size_t level, double threshold) {
  const std::size_t taps = h.size();
  const double root = std::sqrt(0.5);
  std::vector<double> approximation;
  std::vector<double> detail;
  for (std::size_t n = 0; n < input.size(); n += 2) {
    double a = 0;
    double d = 0;
    for (std::size_t i = 0; i < taps; ++i) {
      const double x = i <= n ? input[n - i] : input[0];
      a += h[i] * root * x;
      d += (i % 2 == 0 ? 1 : -1) * h[taps - 1 - i] * root * x;
    }
    approximation.push_back(a);
    detail.push_back(d > threshold ? d - threshold : d < -threshold ? d + threshold : 0);
  }
  std::vector<double> coarse = approximation;
  if (level > 1) coarse = textbook(approximation, h, level - 1, threshold);
  const std::size_t late = fog::denoise_delay(taps, level - 1);
  std::vector<double> output(input.size());
  for (std::size_t n = 0; n < input.size(); ++n) {
    for (std::size_t k = 0; k <= n / 2; ++k) {
      const std::size_t m = n - 2 * k;
      if (m >= taps) continue;
      const double d = k >= late ? detail[k - late] : 0;
      output[n] += 2 * root * (h[taps - 1 - m] * coarse[k] + (m % 2 == 0 ? -1 : 1) * h[m] * d);
    }
  }
  return output;
}

TEST_F(DenoiserTest, SubtractingWhatIsRemovedEqualsShrinkingTheCoefficients) {
  constexpr double kThreshold = 0.8;
  // Filters of an even and of an odd number of pairs, short ones and the longest.
  const std::pair<const char*, int> banks[] = {{"sym8", 5}, {"haar", 4}, {"db2", 4},  {"db3", 4},
                                               {"db5", 1},  {"db7", 2},  {"coif5", 3}};
  for (const auto& [wavelet, levels] : banks) {
    const auto denoiser = make(kThreshold, fog::ThresholdMode::soft, wavelet, levels);
    auto input = random_input(denoiser->delay() * 4 + 1000, 400);
    const std::size_t half = input.size() / 2;
    for (std::size_t i = half; i < input.size(); ++i) {
      input[i] += 3 * static_cast<std::int32_t>(i - half);
    }
    const auto output = run(*denoiser, input);
    std::vector<double> real;
    for (const std::int32_t raw : input) real.push_back(raw / 1024.0);
    const auto expected = textbook(real, filter_, static_cast<std::size_t>(levels), kThreshold);
    double worst = 0;
    for (std::size_t i = 2 * denoiser->delay(); i < output.size(); ++i) {
      worst = std::max(worst, std::abs(output[i] / 1024.0 - expected[i]));
    }
    RecordProperty("worst_error_dph", std::to_string(worst));
    EXPECT_LE(worst, 1.0 / 1024 + removal_bound(filter_, levels) * kThreshold * kNoiseResolution)
        << wavelet;
  }
}

// Haar's filter passes the removed part of a level unchanged; one bit is added per rounding.
TEST(NoiseShift, IsTheSmallestWithWhichNoSumOfRemovedDetailsOverflows) {
  const std::int32_t half = 1 << 14;
  const std::int32_t lower_only[] = {half, half};
  const std::int32_t filters[] = {0, 0, lower_only[0], lower_only[1]};
  const auto shift_of = [&](const std::vector<std::int32_t>& thresholds,
                            fog::ThresholdRule rule = fog::ThresholdRule::fixed) {
    fog::DenoiseParameters parameters;
    parameters.filters = {filters, 4};
    parameters.thresholds = {thresholds.data(), thresholds.size()};
    parameters.rule = rule;
    return fog::noise_shift(parameters);
  };
  EXPECT_EQ(shift_of({0}), 0);
  EXPECT_EQ(shift_of({32765}), 0);
  EXPECT_EQ(shift_of({32766}), 1);
  EXPECT_EQ(shift_of({2 * 32766 - 1}), 1);
  EXPECT_EQ(shift_of({2 * 32766}), 2);
  EXPECT_EQ(shift_of({(32766 << 15) - 1}), 15);
  EXPECT_EQ(shift_of({32766 << 15}), -1);
  EXPECT_EQ(shift_of({1 << 30}), -1);
  EXPECT_EQ(shift_of({16383, 16380}), 0);  // two levels: two bits for each
  EXPECT_EQ(shift_of({16383, 16381}), 1);
  for (const auto rule : {fog::ThresholdRule::sqtwolog, fog::ThresholdRule::heursure}) {
    EXPECT_EQ(shift_of({8191}, rule), 0);  // up to four times as much
    EXPECT_EQ(shift_of({8192}, rule), 1);
  }
}

TEST(NoiseShift, FilterOfTooMuchGain_None) {
  const auto shift_of = [](std::int32_t tap) {
    const std::int32_t synthesis[] = {0, 0, 0, 0, 0, 0, tap, 0, tap, 0, 2, 0};
    const std::int32_t threshold = 0;
    fog::DenoiseParameters parameters;
    parameters.filters = {synthesis, 12};
    parameters.thresholds = {&threshold, 1};
    return fog::noise_shift(parameters);
  };
  EXPECT_EQ(shift_of(INT16_MAX - 1), 0);
  EXPECT_EQ(shift_of(INT16_MAX), -1);
}

TEST(DenoiserMemory, OfWaitingDetails_DelayOfTheLevelsBelow) {
  EXPECT_EQ(fog::denoise_waiting(16, 5), (0U + 1) + (15U + 1) + (45U + 1) + (105U + 1));
}

// An image for a filter, or without one.
TEST_F(DenoiserTest, OptionalDenoiser_WithLevels_IsTheDenoiser) {
  auto any = make(1, fog::ThresholdMode::soft);
  fog::DenoiseParameters parameters = fogcomp::board::read_board_table(table_, "test").denoise;
  parameters.thresholds = {thresholds_.data(), thresholds_.size()};
  const auto optional = std::make_unique<fog::OptionalDenoiser<16, 5>>(parameters);
  EXPECT_EQ(optional->delay(), kDelay);
  for (const std::int32_t raw : random_input(1000, 4000)) {
    const Rate rate = Rate::from_raw(raw);
    ASSERT_EQ(optional->step(rate, true).rate, any->step(rate, true).rate);
    ASSERT_EQ(optional->filling(), any->filling());
  }
}

TEST(OptionalDenoiser, WithoutLevels_PassesTheRate) {
  fog::OptionalDenoiser<16, 5> denoiser{fog::DenoiseParameters()};
  EXPECT_TRUE(denoiser.filling());
  EXPECT_EQ(denoiser.delay(), 0U);
  EXPECT_EQ(denoiser.step(Rate::from_raw(123), true).rate.raw(), 123);
  EXPECT_FALSE(denoiser.filling());
}

TEST(Filters, OfAnyLength_All) {
  EXPECT_EQ(fog::filters_of(fog::kAnyTaps), ~fog::FilterMask{0});
  EXPECT_EQ(fog::filters_of(16), 1U << 8U);
  EXPECT_EQ(fog::filters_of(fog::kOrNone + 16), 1U << 8U | 1U);
}

TEST_F(DenoiserTest, KeepsAConstantAndHasNoStartUpTransient) {
  const auto denoiser = make(2, fog::ThresholdMode::soft);
  for (int i = 0; i < 3000; ++i) {
    ASSERT_EQ(denoiser->step(Rate::from_raw(1234567891), true).rate.raw(), 1234567891);
    ASSERT_EQ(denoiser->filling(), i < static_cast<int>(kDelay));
  }
}

TEST_F(DenoiserTest, OvershootsAStepByTheDerivedBoundAtMost) {
  for (const std::string wavelet : {"haar", "db4", "sym8", "coif5"}) {
    for (const auto mode : {fog::ThresholdMode::soft, fog::ThresholdMode::hard}) {
      constexpr double kThreshold = 3;
      const auto denoiser = make(kThreshold, mode, wavelet);
      const std::size_t delay = denoiser->delay();
      std::vector<std::int32_t> input(4 * delay + 1000, 0);
      for (std::size_t i = 2 * delay; i < input.size(); ++i) input[i] = 100 * 3600 * 1024;
      const auto output = run(*denoiser, input);
      double worst = 0;
      for (std::size_t i = delay; i < output.size(); ++i) {
        worst = std::max(worst, std::abs((output[i] - input[i - delay]) / 1024.0));
      }
      const double bound = removal_bound(filter_, 5) * kThreshold;
      EXPECT_LE(worst, bound * (1 + kNoiseResolution)) << wavelet;
    }
  }
}

// README.md of the denoiser states it.
TEST_F(DenoiserTest, HasTheDocumentedBoundForSym8) {
  EXPECT_NEAR(removal_bound(fogcomp::denoise::lowpass_filter("sym8"), 5), 8.70, 0.01);
}

TEST_F(DenoiserTest, RemovesAnOutlierOfOneSample) {
  for (const auto rule : {fog::ThresholdRule::fixed, fog::ThresholdRule::heursure}) {
    for (const std::size_t at : {3000U, 3001U}) {
      const auto clean = make(2, fog::ThresholdMode::soft, "sym8", 5, rule);
      auto input = random_input(6000, 1024);
      const auto expected = run(*clean, input);
      const auto denoiser = make(2, fog::ThresholdMode::soft, "sym8", 5, rule);
      input[at] += 50000 * 1024;
      const auto output = run(*denoiser, input);
      for (std::size_t i = 0; i < output.size(); ++i) {
        ASSERT_LE(std::abs(output[i] - expected[i]), 3 * 1024) << i;
      }
    }
  }
}

TEST_F(DenoiserTest, StaysBoundedAtFullScaleWithoutOverflow) {
  for (const auto rule : {fog::ThresholdRule::fixed, fog::ThresholdRule::heursure}) {
    constexpr double kThreshold = 100;
    const auto denoiser = make(kThreshold, fog::ThresholdMode::soft, "sym8", 5, rule);
    const auto extreme = [this] { return random_() % 2 == 0 ? INT32_MIN : INT32_MAX; };
    std::vector<std::int32_t> input(20000);
    for (std::size_t i = 0; i < input.size(); ++i) {
      input[i] = i % 4000 < 2000 ? extreme() : static_cast<std::int32_t>(random_());
    }
    const auto output = run(*denoiser, input);
    const double gain = rule == fog::ThresholdRule::fixed ? 1 : fog::kMaxThresholdScale;
    const double bound = gain * removal_bound(filter_, 5) * kThreshold;
    for (std::size_t i = kDelay + 1; i < output.size(); ++i) {
      // An outlier is replaced by the sample before it.
      const double own = std::abs(output[i] / 1024.0 - input[i - kDelay] / 1024.0);
      const double stand_in = std::abs(output[i] / 1024.0 - input[i - kDelay - 1] / 1024.0);
      ASSERT_LE(std::min(own, stand_in), bound * (1 + kNoiseResolution)) << i;
    }
    EXPECT_EQ(fog::test::overflows(), 0U);
  }
}

TEST_F(DenoiserTest, FollowsTheNoiseWhereItIsNotWhatTheTableExpected) {
  for (const double factor : {0.2, 1.0, 3.0}) {
    const auto denoiser = make(3.115 / std::sqrt(2), fog::ThresholdMode::soft, "sym8", 1,
                               fog::ThresholdRule::sqtwolog);
    std::normal_distribution<double> normal(0, 1024 * factor);
    double square = 0;
    constexpr int kSamples = 60000;
    constexpr int kSettled = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const auto raw = static_cast<std::int32_t>(std::lround(normal(random_)));
      const double value = denoiser->step(Rate::from_raw(raw), true).rate.raw() / 1024.0;
      if (i >= kSettled) square += value * value;
    }
    // One level removes the whole upper half of the band.
    EXPECT_NEAR(std::sqrt(square / (kSamples - kSettled)) / factor, std::sqrt(0.5), 0.02);
  }
}

TEST_F(DenoiserTest, RunsEveryShapeThatATableMayAskFor) {
  for (const std::string& wavelet : fogcomp::denoise::wavelet_names()) {
    for (const int levels : {1, 2, 5, 7, 10}) {
      if (levels == 10 && wavelet != "haar" && wavelet != "coif5") continue;
      const auto denoiser = make(0, fog::ThresholdMode::soft, wavelet, levels);
      const std::size_t delay = denoiser->delay();
      EXPECT_EQ(delay, fog::denoise_delay(filter_.size(), static_cast<std::size_t>(levels)));
      const auto input = random_input(2 * delay + 100, INT32_MAX);
      const auto output = run(*denoiser, input);
      for (std::size_t i = delay; i < output.size(); ++i) ASSERT_EQ(output[i], input[i - delay]);
    }
  }
}

// An image runs the same kernels, only chosen when it is compiled.
TEST_F(DenoiserTest, IsTheSameInAnImageOfExactlyItsShape) {
  auto any = make(1, fog::ThresholdMode::soft, "sym8", 5, fog::ThresholdRule::heursure);
  fog::DenoiseParameters parameters = fogcomp::board::read_board_table(table_, "test").denoise;
  parameters.thresholds = {thresholds_.data(), thresholds_.size()};
  const auto exact = std::make_unique<fog::Denoiser<16, 5>>(parameters);
  for (const std::int32_t raw : random_input(30000, 4000)) {
    ASSERT_EQ(any->step(Rate::from_raw(raw), true).rate.raw(),
              exact->step(Rate::from_raw(raw), true).rate.raw());
  }
}

TEST_F(DenoiserTest, ReducesWhiteNoise) {
  const auto denoiser = make(2.6, fog::ThresholdMode::soft);
  std::normal_distribution<double> normal(0, 1024);
  double square = 0;
  constexpr int kSamples = 50000;
  for (int i = 0; i < kSamples; ++i) {
    const auto raw = static_cast<std::int32_t>(std::lround(normal(random_)));
    const double value = denoiser->step(Rate::from_raw(raw), true).rate.raw() / 1024.0;
    if (i >= 1000) square += value * value;
  }
  EXPECT_LE(std::sqrt(square / kSamples),
            0.2);  // of a noise of 1: what is left is level 5's approximation
}

TEST_F(DenoiserTest, AnInvalidSampleSpoilsOnlyItself) {
  const auto denoiser = make(0, fog::ThresholdMode::soft);
  for (std::size_t i = 0; i < 3000; ++i) {
    const bool valid = i != 1000;
    const Rate rate = Rate::from_raw(valid ? 5000 : INT32_MAX);
    const auto output = denoiser->step(rate, valid);
    ASSERT_EQ(output.rate.raw(), 5000) << i;
    ASSERT_EQ(output.valid, i != 1000 + kDelay) << i;
  }
}

TEST_F(DenoiserTest, GivesNothingValidBeforeTheFirstValidSample) {
  const auto denoiser = make(1, fog::ThresholdMode::soft);
  EXPECT_FALSE(denoiser->step(Rate::from_raw(77), false).valid);
  const auto first = denoiser->step(Rate::from_raw(5), true);
  EXPECT_TRUE(first.valid);
  EXPECT_EQ(first.rate.raw(), 5);
}

}  // namespace
