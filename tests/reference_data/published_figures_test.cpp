// Allan deviations and wavelet filters against published figures.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "denoise/filters.hpp"
#include "noise/allan.hpp"

namespace fogcomp {
namespace {

// NIST SP 1065, 12.1: 9 values of frequency.
TEST(Sp1065, NineValues_OverlappingDeviations) {
  const std::vector<double> values{892, 809, 823, 798, 671, 644, 883, 903, 677};
  const auto points = noise::allan_deviation(values, {{0, values.size()}}, 1);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].sigma, 91.22945, 5e-6);
  EXPECT_NEAR(points[1].sigma, 85.95287, 5e-6);
}

// NIST SP 1065, 12.4: the generator of the 1000 values.
std::vector<double> thousand_values() {
  constexpr std::uint64_t kModulus = 2147483647;
  std::vector<double> values;
  std::uint64_t state = 1234567890;
  for (int i = 0; i < 1000; ++i) {
    values.push_back(static_cast<double>(state) / static_cast<double>(kModulus));
    state = 16807 * state % kModulus;
  }
  return values;
}

// Neighbouring means of so many samples, once for each first sample that they can have: pooled,
// they are the overlapping estimate at this time, which need not be an octave.
double overlapping_deviation(const std::vector<double>& values, std::size_t samples) {
  std::vector<double> means;
  std::vector<recording::RowRange> ranges;
  for (std::size_t first = 0; first < samples; ++first) {
    const std::size_t begin = means.size();
    for (std::size_t i = first; i + samples <= values.size(); i += samples) {
      double sum = 0;
      for (std::size_t k = i; k < i + samples; ++k) sum += values[k];
      means.push_back(sum / static_cast<double>(samples));
    }
    ranges.push_back({begin, means.size()});
  }
  return noise::allan_deviation(means, ranges, 1).front().sigma;
}

TEST(Sp1065, ThousandValues_OverlappingDeviations) {
  const std::vector<double> values = thousand_values();
  EXPECT_NEAR(noise::allan_deviation(values, {{0, 1000}}, 1).front().sigma, 2.922319e-01, 5e-8);
  EXPECT_NEAR(overlapping_deviation(values, 10), 9.159953e-02, 5e-9);
  EXPECT_NEAR(overlapping_deviation(values, 100), 3.241343e-02, 5e-9);
}

// Each line of daubechies.txt: name, low-pass filter.
TEST(Daubechies, Filters_ArePublished) {
  std::ifstream file(std::string(FOG_SOURCE_DIR) + "/tests/reference_data/daubechies.txt");
  int filters = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    if (!(words >> name) || name[0] == '#') continue;
    std::vector<double> published;
    for (double tap = 0; words >> tap;) published.push_back(tap);
    const std::vector<double>& own = denoise::lowpass_filter(name);
    ASSERT_EQ(own.size(), published.size()) << name;
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_NEAR(own[i], published[i], 2e-12) << name << " tap " << i;
    }
    ++filters;
  }
  EXPECT_EQ(filters, 10);
}

}  // namespace
}  // namespace fogcomp
