#include "recording/mask.hpp"

#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace fogcomp::recording {
namespace {

TEST(Cut, ATimeAloneAndWithARun_AreRead) {
  EXPECT_EQ(parse_cut("3600").at_s, 3600);
  EXPECT_EQ(parse_cut("3600").run, "");
  EXPECT_EQ(parse_cut("a:b.csv:12.5").run, "a:b.csv");
  EXPECT_EQ(cut_text(parse_cut("a:b.csv:12.5")), "a:b.csv:12.5");
}

TEST(Cut, WhatIsNoTime_Refused) {
  for (const char* text : {"", "x", "run.csv:", "1..2", "run.csv"})
    EXPECT_THROW(parse_cut(text), InputError) << text;
}

TEST(Cut, OfAnotherRun_Refused) {
  EXPECT_NO_THROW(require_cut_runs({{"run.csv", 5}, {"", 5}}, {"folder/run.csv"}));
  EXPECT_THROW(require_cut_runs({{"other.csv", 5}}, {"folder/run.csv"}), InputError);
}

}  // namespace
}  // namespace fogcomp::recording
