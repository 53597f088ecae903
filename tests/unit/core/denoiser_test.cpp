#include "core/denoise/denoiser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "support/overflow_guard.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::Rate;
using Denoiser = fog::Denoiser<fog::kMostTaps, fog::kMostLevels>;

constexpr std::size_t kDelay = 465;

// sym8 x 5 with the same threshold on every level.
class DenoiserTest : public testing::Test {
 protected:
  std::unique_ptr<Denoiser> make(double threshold_dph, fog::ThresholdMode mode) {
    taps_ = fog::test::sym8_taps();
    thresholds_.assign(5, static_cast<std::int32_t>(std::lround(std::ldexp(threshold_dph, 16))));
    return std::make_unique<Denoiser>(fog::DenoiseParameters{
        {taps_.data(), taps_.size()}, {thresholds_.data(), thresholds_.size()}, mode});
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
  std::vector<std::int32_t> taps_;
  std::vector<std::int32_t> thresholds_;
};

TEST_F(DenoiserTest, WithThresholdZeroIsTheInputDelayedBy465SamplesBitForBit) {
  const auto denoiser = make(0, fog::ThresholdMode::soft);
  EXPECT_EQ(denoiser->delay(), kDelay);
  const auto input = random_input(5000, INT32_MAX);
  const auto output = run(*denoiser, input);
  for (std::size_t i = 0; i < output.size(); ++i) {
    ASSERT_EQ(output[i], i < kDelay ? input[0] : input[i - kDelay]) << i;
  }
}

// The form that the firmware computes, delayed input - synthesis(what was removed), equals the
// textbook form. Textbook, in double: analysis, soft threshold, synthesis, with the whole tree
// written out.
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
  const auto denoiser = make(kThreshold, fog::ThresholdMode::soft);
  const auto input = random_input(6000, 2048);
  const auto output = run(*denoiser, input);
  std::vector<double> real;
  for (const std::int32_t raw : input) real.push_back(raw / 1024.0);
  const auto expected = textbook(real, fog::test::sym8_filter(), 5, kThreshold);
  double worst = 0;
  for (std::size_t i = 2 * kDelay; i < output.size(); ++i) {
    worst = std::max(worst, std::abs(output[i] / 1024.0 - expected[i]));
  }
  RecordProperty("worst_error_dph", std::to_string(worst));
  EXPECT_LE(worst, 2.5 / 1024);
}

TEST_F(DenoiserTest, KeepsAConstantAndHasNoStartUpTransient) {
  const auto denoiser = make(2, fog::ThresholdMode::soft);
  for (int i = 0; i < 3000; ++i) {
    ASSERT_EQ(denoiser->step(Rate::from_raw(1234567891), true).rate.raw(), 1234567891);
    ASSERT_EQ(denoiser->filling(), i < static_cast<int>(kDelay));
  }
}

TEST_F(DenoiserTest, LeavesARotationOfAnySizeWithinTheThresholds) {
  for (const auto mode : {fog::ThresholdMode::soft, fog::ThresholdMode::hard}) {
    constexpr double kThreshold = 3;
    const auto denoiser = make(kThreshold, mode);
    std::vector<std::int32_t> input(6000, 0);
    for (std::size_t i = 2000; i < input.size(); ++i) input[i] = 100 * 3600 * 1024;  // 100 deg/s
    const auto output = run(*denoiser, input);
    double worst = 0;
    for (std::size_t i = kDelay; i < output.size(); ++i) {
      worst = std::max(worst, std::abs((output[i] - input[i - kDelay]) / 1024.0));
    }
    // Sum over levels of threshold * (synthesis gain): SPEC.md, "Denoiser".
    EXPECT_LE(worst, 13 * kThreshold);
  }
}

TEST_F(DenoiserTest, StaysBoundedAtFullScaleWithoutOverflow) {
  const auto denoiser = make(1000, fog::ThresholdMode::soft);
  std::vector<std::int32_t> input(20000);
  for (std::int32_t& value : input) value = random_() % 2 == 0 ? INT32_MIN : INT32_MAX;
  run(*denoiser, input);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST_F(DenoiserTest, ReducesWhiteNoise) {
  const auto denoiser = make(3.7, fog::ThresholdMode::soft);
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
