#include "compare/comparison.hpp"

#include <gtest/gtest.h>

namespace fogcomp::compare {
namespace {

model::Model trained() {
  model::Model model;
  model.terms = {{"bias", {}, {{0.7, 0.01}}}};
  model.min_degc = -41;
  model.max_degc = 61;
  model.rate_range_degc_per_min = model::Range{-0.7, 0.9};
  model.time_range_s = model::Range{600, 36000};
  return model;
}

fog::BlockMeans<model::RealNumbers> at(double degc) {
  fog::BlockMeans<model::RealNumbers> means;
  means.temperature = degc;
  return means;
}

TEST(TrainedRange, CountsRowsOutsideEachRange) {
  TrainedRange range(trained(), 10);
  range.count(700, at(20), 0);
  range.count(700, at(62), 0);
  range.count(700, at(20), 3);
  range.count(50, at(20), -1);
  const auto outside = range.outside();
  EXPECT_DOUBLE_EQ(outside.temperature, 0.25);
  EXPECT_DOUBLE_EQ(outside.temperature_rate, 0.5);
  EXPECT_DOUBLE_EQ(outside.sooner, 0.25);
}

// A longer run is no reason to warn unless the model has an effect of the time since power-on.
TEST(TrainedRange, WarnsOfLaterTimesOnlyWhereTheyCount) {
  model::Model model = trained();
  TrainedRange without(model, 10);
  without.count(50000, at(20), 0);
  EXPECT_EQ(without.outside().later, 0);
  model.terms.push_back({"warm_up", {{3600}, {0}}, {{1, 0.1}}});
  TrainedRange with(model, 10);
  with.count(50000, at(20), 0);
  EXPECT_EQ(with.outside().later, 1);
}

// Rows of a table that stands differ by a little.
TEST(TrainedRange, WarnsOfInputRatesBeyondTheTrainedOnes) {
  model::Model model = trained();
  const auto outside = [&model](double input_rate_dph) {
    TrainedRange range(model, 10);
    auto means = at(20);
    means.input_rate = input_rate_dph;
    range.count(700, means, 0);
    return range.outside().input_rate;
  };
  EXPECT_EQ(outside(3e5), 0);
  model.input_rate_range_dph = model::Range{-72000, 72000};
  EXPECT_EQ(outside(72100), 0);
  EXPECT_EQ(outside(180000), 1);
}

TEST(TrainedRange, WarnsOfInputsThatTheModelNeeds) {
  model::Model model = trained();
  constexpr std::size_t kPower = extension_number(fog::Input::light_power);
  model.input_ranges[kPower] = model::InputRange{{90, 110}, 1};
  const auto outside = [&model](double power) {
    TrainedRange range(model, 10);
    auto means = at(20);
    means.extension[kPower] = power;
    range.count(700, means, 0);
    return range.outside().inputs[kPower];
  };
  EXPECT_EQ(outside(120), 0);
  model.terms.push_back({"light_power", {}, {{1, 0.1}}});
  EXPECT_EQ(outside(120), 1);
  EXPECT_EQ(outside(100), 0);
}

TEST(TrainedRange, OfAnOlderModelKnowsOnlyTemperature) {
  model::Model model = trained();
  model.rate_range_degc_per_min.reset();
  model.time_range_s.reset();
  TrainedRange range(model, 10);
  range.count(0, at(-50), 30);
  EXPECT_EQ(range.outside().temperature, 1);
  EXPECT_EQ(range.outside().temperature_rate, 0);
  EXPECT_EQ(range.outside().sooner, 0);
}

}  // namespace
}  // namespace fogcomp::compare
