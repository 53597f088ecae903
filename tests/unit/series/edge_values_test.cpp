#include "series/block_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fogcomp::series {
namespace {

std::vector<double> at_ends(const std::vector<double>& means) {
  std::vector<double> values;
  const auto size = static_cast<std::ptrdiff_t>(means.size());
  for (std::ptrdiff_t i = -1; i < size; ++i) {
    values.push_back(edge_at_end_of(means.data(), size, i).value);
  }
  return values;
}

TEST(EdgeValues, OfAStraightLineAreExactAtItsEndsToo) {
  EXPECT_EQ(at_ends({0.5, 1.5, 2.5, 3.5}), (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(EdgeValues, OfFewSamples) {
  EXPECT_EQ(at_ends({7}), (std::vector<double>{7, 7}));
  EXPECT_EQ(at_ends({1, 3}), (std::vector<double>{0, 2, 4}));
}

// From rest to a slope of 8 within the fourth sample, 3/4 of it at rest.
TEST(EdgeValues, ACornerWithinASampleRoundsNoEdge) {
  EXPECT_EQ(at_ends({0, 0, 0, 0.25, 6, 14, 22}), (std::vector<double>{0, 0, 0, 0, 2, 10, 18, 26}));
}

// The mean rate of change of every sample of a sine, by its edges, to a part of (2 pi / 31)^4 but
// at its ends.
TEST(EdgeValues, OfASineGiveItsRateOfChange) {
  const double w = 2 * M_PI / 31;
  std::vector<double> means;
  for (int i = 0; i < 310; ++i) {
    means.push_back((std::cos(w * i) - std::cos(w * (i + 1))) / w);
  }
  const std::vector<double> values = at_ends(means);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_at_end = i < 3 || i + 3 >= values.size();
    const double error = is_at_end ? w * w / 2 : w * w * w * w / 20;
    EXPECT_NEAR(values[i], std::sin(w * static_cast<double>(i)), error) << i;
  }
}

}  // namespace
}  // namespace fogcomp::series
