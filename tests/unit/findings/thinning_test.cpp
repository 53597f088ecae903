#include "findings/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fogcomp::findings {
namespace {

// A recording of 16.5 h at 200 Hz: a sine that decimation by picking rows would alias, one spike.
struct Long {
  static constexpr std::size_t kRows = 11'910'000;
  static constexpr std::size_t kSpike = 7'654'321;
  std::vector<double> time_s;
  std::vector<double> value;
  Long() : time_s(kRows), value(kRows) {
    for (std::size_t i = 0; i < kRows; ++i) {
      time_s[i] = static_cast<double>(i) / 200;
      value[i] = std::sin(static_cast<double>(i));
    }
    value[kSpike] = 50;
  }
};

TEST(MinAndMax, KeepsEveryColumnsExtremesAndTheSpikeOfAnyLongRun) {
  const Long run;
  const Curves curves = min_and_max(run.time_s, {&run.value}, {0});
  ASSERT_LE(curves.x.size(), 2 * kColumns + 2);
  ASSERT_EQ(curves.y[0].size(), curves.x.size());
  EXPECT_TRUE(std::is_sorted(curves.x.begin(), curves.x.end()));
  const auto spike = std::max_element(curves.y[0].begin(), curves.y[0].end());
  EXPECT_EQ(*spike, 50);
  const double at_s = curves.x[static_cast<std::size_t>(spike - curves.y[0].begin())];
  EXPECT_NEAR(at_s, run.time_s[Long::kSpike], run.time_s.back() / kColumns);
  for (std::size_t i = 0; i + 2 < curves.x.size(); i += 2) {
    const auto [min, max] = std::minmax(curves.y[0][i], curves.y[0][i + 1]);
    EXPECT_LT(min, -0.99999);
    EXPECT_GT(max, 0.99999);
  }
}

TEST(MinAndMax, LeavesShortRunsAsTheyAre) {
  const std::vector<double> x{0, 1, 2, 10, 11};
  const std::vector<double> y{5, 3, 4, 1, 2};
  const Curves curves = min_and_max(x, {&y}, {0, 3});
  ASSERT_EQ(curves.x, (std::vector<double>{0, 1, 2, 6, 10, 11}));
  EXPECT_TRUE(std::isnan(curves.y[0][3]));
  EXPECT_EQ(curves.y[0][2], 4);
  EXPECT_EQ(curves.y[0][4], 1);
}

TEST(MinAndMax, ManyShortGapsDoNotAddPoints) {
  std::vector<double> x;
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < 100'000; ++i) {
    if (i % 10 == 0) starts.push_back(i);
    x.push_back(static_cast<double>(i + 2 * (i / 10)));
  }
  const Curves curves = min_and_max(x, {&x}, starts);
  EXPECT_LE(curves.x.size(), 2 * kColumns + 2);
  EXPECT_TRUE(std::none_of(curves.y[0].begin(), curves.y[0].end(),
                           [](double value) { return std::isnan(value); }));
}

TEST(ColumnMeans, OfASumAreTheSumOfTheMeans) {
  std::vector<double> x;
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> sum;
  for (int i = 0; i < 50'000; ++i) {
    x.push_back(i);
    a.push_back(std::sin(0.7 * i));
    b.push_back(std::cos(0.01 * i));
    sum.push_back(a.back() + b.back());
  }
  const Curves curves = column_means(x, {&a, &b, &sum}, {0});
  ASSERT_LE(curves.x.size(), kColumns + 1);
  for (std::size_t i = 0; i < curves.x.size(); ++i) {
    EXPECT_NEAR(curves.y[0][i] + curves.y[1][i], curves.y[2][i], 1e-12);
  }
}

TEST(Thinned, AveragesRowsOfOneBranchOnly) {
  const std::vector<double> x{0, 1, 2, 3, 4, 5};
  const std::vector<double> y{0, 2, 100, 6, 8, 10};
  const std::vector<compare::Branch> branch{compare::Branch::heating, compare::Branch::heating,
                                            compare::Branch::cooling, compare::Branch::heating,
                                            compare::Branch::heating, compare::Branch::heating};
  const Cloud cloud = thinned(x, y, branch, compare::Branch::heating, 2);
  EXPECT_EQ(cloud.x, (std::vector<double>{0.5, 3.5, 5}));
  EXPECT_EQ(cloud.y, (std::vector<double>{1, 7, 10}));
}

}  // namespace
}  // namespace fogcomp::findings
