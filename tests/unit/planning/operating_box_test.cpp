#include "planning/operating_box.hpp"

#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace fogcomp::planning {
namespace {

constexpr OperatingBox kOthers{{-40, 85}, {-3, 3}, 0};

TEST(OperatingBox, GivenParts_ReplaceTheOthers) {
  const OperatingBox box = parse_box("--use", "T:-40..60, ramp:-1..2, rate:200", kOthers);
  EXPECT_EQ(box.temperature_degc.max, 60);
  EXPECT_EQ(box.ramp_degc_per_min.min, -1);
  EXPECT_EQ(box.ramp_degc_per_min.max, 2);
  EXPECT_EQ(box.rate_dps, 200);
  EXPECT_EQ(parse_box("--use", "ramp:1", kOthers).temperature_degc.max, 85);
  EXPECT_EQ(box_text(box), "T:-40..60,ramp:-1..2,rate:200");
  EXPECT_EQ(box_text(parse_box("--use", "ramp:1", kOthers)), "T:-40..85,ramp:1");
}

TEST(OperatingBox, WhatIsNoBox_IsRefusedInOneLine) {
  for (const char* text :
       {"", "T:20", "T:60..-40", "T:-400..60", "T:20..20.5", "ramp:0", "ramp:-1", "ramp:1..3",
        "rate:-1", "rate:2000", "rate:1..2", "hot:3", "T:-40..60,", "T:a..b", "T"}) {
    try {
      parse_box("--use", text, kOthers);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind("--use: ", 0), 0U) << what;
      EXPECT_NE(what.find("T:-40..60,ramp:3"), std::string::npos) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
  }
}

TEST(OperatingBox, OfAModel_IsThatOfItsRuns) {
  model::Model model;
  model.min_degc = -30;
  model.max_degc = 50;
  model.rate_range_degc_per_min = model::Range{-0.4, 0.6};
  const OperatingBox box = box_of_runs(model, kOthers);
  EXPECT_EQ(box_text(box), "T:-30..50,ramp:-0.4..0.6");
  EXPECT_TRUE(kOthers.holds(box));
  EXPECT_FALSE(box.holds(kOthers));
}

}  // namespace
}  // namespace fogcomp::planning
