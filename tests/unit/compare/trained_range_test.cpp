#include "compare/trained_range.hpp"

#include <gtest/gtest.h>

namespace fogcomp::compare {
namespace {

model::Model trained() {
  model::Model model;
  model.terms = {{"bias", {}, {}, {}, {0.7}, {0.01}}};
  model.min_degc = -41;
  model.max_degc = 61;
  model.rate_range_degc_per_min = model::Range{-0.7, 0.9};
  model.time_range_s = model::Range{600, 36000};
  return model;
}

TEST(TrainedRange, CountsRowsOutsideEachRange) {
  TrainedRange range(trained(), 10);
  range.count(700, 20, 0);
  range.count(700, 62, 0);
  range.count(700, 20, 3);
  range.count(50, 20, -1);
  const auto outside = range.outside();
  EXPECT_DOUBLE_EQ(outside.temperature, 0.25);
  EXPECT_DOUBLE_EQ(outside.temperature_rate, 0.5);
  EXPECT_DOUBLE_EQ(outside.sooner, 0.25);
}

// A longer run is no reason to warn unless the model has an effect of the time since power-on.
TEST(TrainedRange, WarnsOfLaterTimesOnlyWhereTheyCount) {
  model::Model model = trained();
  TrainedRange without(model, 10);
  without.count(50000, 20, 0);
  EXPECT_EQ(without.outside().later, 0);
  model.terms.push_back({"warm_up", {3600, 0}, {false, false}, {0, 0}, {1}, {0.1}});
  TrainedRange with(model, 10);
  with.count(50000, 20, 0);
  EXPECT_EQ(with.outside().later, 1);
}

TEST(TrainedRange, OfAnOlderModelKnowsOnlyTemperature) {
  model::Model model = trained();
  model.rate_range_degc_per_min.reset();
  model.time_range_s.reset();
  TrainedRange range(model, 10);
  range.count(0, -50, 30);
  EXPECT_EQ(range.outside().temperature, 1);
  EXPECT_EQ(range.outside().temperature_rate, 0);
  EXPECT_EQ(range.outside().sooner, 0);
}

}  // namespace
}  // namespace fogcomp::compare
