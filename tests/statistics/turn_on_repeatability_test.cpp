#include <gtest/gtest.h>

#include <random>

#include "unit/fit/runs_apart.hpp"

namespace {

using fog::test::chance_of_slope;
using fog::test::runs_apart;

TEST(TurnOnRepeatability, IsSeldomTakenForADriftBetweenRecordings) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 100;
  int below_a_tenth = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<double> biases_dph;
    for (int i = 0; i < 5; ++i) biases_dph.push_back(0.3 * normal(random));
    below_a_tenth += chance_of_slope(runs_apart(biases_dph, 0, 1e-4)) < 0.1 ? 1 : 0;
  }
  EXPECT_GE(below_a_tenth, 3);
  EXPECT_LE(below_a_tenth, 19);
}

}  // namespace
