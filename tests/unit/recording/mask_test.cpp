// Masks: their syntax, their files, and that masked rates are used nowhere while the temperatures
// are.

#include "recording/mask.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/input_error.hpp"

namespace fogcomp::recording {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_mask(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Mask, IsTypedAsTwoTimesAndPerhapsARun) {
  const Mask all = parse_mask("3600..7200.5");
  EXPECT_EQ(all.run, "");
  EXPECT_EQ(all.from_s, 3600);
  EXPECT_EQ(all.to_s, 7200.5);
  const Mask one = parse_mask("a:b.csv:-10..0");
  EXPECT_EQ(one.run, "a:b.csv");
  EXPECT_EQ(one.from_s, -10);
}

TEST(Mask, ThatIsNoneIsRefusedWithAnExample) {
  for (const char* text :
       {"", "..", "1..", "..2", "1-2", "1..2..3", "run.csv", "a..b", "run.csv:"}) {
    EXPECT_NE(refusal(text).find("as 3600..7200"), std::string::npos)
        << text << ": " << refusal(text);
  }
  EXPECT_NE(refusal("2..1").find("ends before it begins"), std::string::npos);
}

TEST(Mask, IsForTheFilesThatItNames) {
  const std::vector<Mask> masks{parse_mask("1..2"), parse_mask("run.csv:3..4"),
                                parse_mask("a/run.csv:5..6")};
  EXPECT_EQ(masks_of(masks, "a/run.csv").size(), 3U);
  EXPECT_EQ(masks_of(masks, "b/run.csv").size(), 2U);
  EXPECT_EQ(masks_of(masks, "other.csv").size(), 1U);
  EXPECT_NO_THROW(require_masked_runs(masks, {"a/run.csv"}));
  EXPECT_THROW(require_masked_runs(masks, {"b/run.csv"}), InputError);
}

TEST(Mask, HidesBothEnds) {
  const std::vector<double> time_s{-1, 0.999, 1, 1.5, 2, 2.001, 7, 8, 9};
  const std::vector<bool> expected{false, false, true, true, true, false, false, true, true};
  EXPECT_EQ(covered({parse_mask("8..100"), parse_mask("1..2"), parse_mask("3..4")}, time_s),
            expected);
  EXPECT_EQ(covered({}, time_s), std::vector<bool>(time_s.size()));
}

}  // namespace
}  // namespace fogcomp::recording
