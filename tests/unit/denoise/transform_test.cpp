#include "denoise/transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "denoise/denoise.hpp"
#include "denoise/filters.hpp"
#include "denoise/outliers.hpp"
#include "unit/denoise/view.hpp"

namespace fogcomp::denoise {
namespace {

using fog::test::view;

std::vector<double> white_noise(std::size_t size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(size);
  for (double& value : values) value = normal(random);
  return values;
}

TEST(WaveletFilters, AreOrthonormalWithTheMomentsOfTheirFamilyVanishing) {
  for (const std::string& name : wavelet_names()) {
    const std::vector<double>& h = lowpass_filter(name);
    const std::size_t taps = h.size();
    for (std::size_t shift = 0; shift < taps; shift += 2) {
      double product = 0;
      for (std::size_t i = 0; i + shift < taps; ++i) product += h[i] * h[i + shift];
      EXPECT_NEAR(product, shift == 0 ? 1 : 0, 4e-16) << name << " shift " << shift;
    }
    const std::vector<double> g = highpass_filter(h);
    const std::size_t moments = name.compare(0, 4, "coif") == 0 ? taps / 3 : taps / 2;
    for (std::size_t m = 0; m < moments; ++m) {
      double moment = 0;
      for (std::size_t i = 0; i < taps; ++i) {
        // Position within +-1, so that high powers do not drown in rounding.
        const double x = 2 * static_cast<double>(i) / static_cast<double>(taps - 1) - 1;
        moment += std::pow(x, static_cast<double>(m)) * g[i];
      }
      EXPECT_NEAR(moment, 0, 1e-14) << name << " moment " << m;
    }
  }
}

TEST(WaveletTransform, IsReversibleForAnyLengthLevelAndExtension) {
  for (const std::string& name : wavelet_names()) {
    const std::vector<double>& taps = lowpass_filter(name);
    for (const std::size_t size : {1U, 2U, 3U, 29U, 511U, 512U, 513U, 1024U, 1025U, 5955U}) {
      const std::vector<double> signal = white_noise(size, 1);
      for (const auto extension : {Extension::symmetric, Extension::periodic}) {
        std::vector<double> again = signal;
        const auto parts = decompose({again.data(), size}, taps, 10, extension);
        reconstruct(parts, taps, {again.data(), size});
        for (std::size_t i = 0; i < size; ++i) ASSERT_NEAR(again[i], signal[i], 1e-12) << name;
      }
    }
  }
}

TEST(WaveletTransform, AllowsTheLevelsThatTheLengthCarries) {
  EXPECT_EQ(max_levels(1, 16), 0);
  EXPECT_EQ(max_levels(29, 16), 0);
  EXPECT_EQ(max_levels(30, 16), 1);
  EXPECT_EQ(max_levels(480, 16), 5);
  EXPECT_EQ(max_levels(1024, 2), 10);
}

// Of so many values those about the median are sought first, between quantiles of a sample.
TEST(NoiseOf, ManyValues_IsTheirMedianMagnitude) {
  for (const std::size_t size : {32768U, 100'000U, 100'001U}) {
    std::vector<double> wave(size);
    for (std::size_t i = 0; i < size; ++i) wave[i] = i % 8 == 0 ? 3 : static_cast<double>(i % 7);
    for (const std::vector<double>& values :
         {white_noise(size, 3), wave, std::vector<double>(size, -2.5)}) {
      std::vector<double> sorted;
      for (const double value : values) sorted.push_back(std::abs(value));
      std::sort(sorted.begin(), sorted.end());
      const double median = (sorted[(size - 1) / 2] + sorted[size / 2]) / 2;
      EXPECT_DOUBLE_EQ(noise_of(view(values)), median / 0.6745) << size;
    }
  }
}

TEST(OfflineDenoise, LeavesAConstantAsItIs) {
  std::vector<double> values(1000, 0.7197);
  denoise({values.data(), values.size()}, {});
  for (const double value : values) ASSERT_NEAR(value, 0.7197, 1e-12);
}

TEST(OfflineDenoise, KeepsTheMean) {
  std::vector<double> values = white_noise(5955, 6);
  double before = 0;
  for (double& value : values) before += (value *= 0.0236) / 5955;
  denoise({values.data(), values.size()}, {});
  double after = 0;
  for (const double value : values) after += value / 5955;
  EXPECT_NEAR(after, before, 1e-5);
}

TEST(Outliers, OfOneSampleAreReplacedWhileStepsRampsAndOscillationsStay) {
  std::vector<double> values = white_noise(2000, 7);
  values[1000] += 40;
  values[1500] -= 25;
  EXPECT_EQ(remove_outliers({values.data(), values.size()}, 5), 2U);
  EXPECT_LT(std::abs(values[1000]), 5);
  EXPECT_LT(std::abs(values[1500]), 5);

  std::vector<double> motion(2000, 0.0);
  for (std::size_t i = 500; i < 1000; ++i) motion[i] = 3.6e5;  // a step and back
  for (std::size_t i = 1000; i < 2000; ++i) {
    motion[i] = 3.6e5 * std::sin(static_cast<double>(i - 1000) * 0.06);  // 2 Hz at 200 Hz
  }
  const std::vector<double> before = motion;
  EXPECT_EQ(remove_outliers({motion.data(), motion.size()}, 5), 0U);
  EXPECT_EQ(motion, before);
}

}  // namespace
}  // namespace fogcomp::denoise
