#include <gtest/gtest.h>

#include "support/text.hpp"

namespace {

const std::vector<std::string> kNames{"shupe", "temperature_rate", "temperature_rate_product",
                                      "glass_transition", "aging"};

TEST(Nearest, IsWhatWasMistyped) {
  EXPECT_EQ(fogcomp::nearest("shuep", kNames), "shupe");
  EXPECT_EQ(fogcomp::nearest("temprature_rate", kNames), "temperature_rate");
}

TEST(Nearest, IsTheOnlyNameThatWasBegun) {
  EXPECT_EQ(fogcomp::nearest("glas", kNames), "glass_transition");
  EXPECT_EQ(fogcomp::nearest("temp", kNames), "");  // two of them
}

TEST(DidYouMean, KnowsAbbreviationsAndSeveralCandidates) {
  EXPECT_EQ(fogcomp::did_you_mean("temp_rate", kNames),
            " (did you mean 'temperature_rate' or 'temperature_rate_product'?)");
  EXPECT_EQ(fogcomp::did_you_mean("rate_prod", kNames),
            " (did you mean 'temperature_rate_product'?)");
  EXPECT_EQ(fogcomp::did_you_mean("transition", kNames), " (did you mean 'glass_transition'?)");
  EXPECT_EQ(fogcomp::did_you_mean("temp", kNames),
            " (did you mean 'temperature_rate' or 'temperature_rate_product'?)");
  EXPECT_EQ(fogcomp::did_you_mean("rate_temp", kNames), "");
  EXPECT_EQ(fogcomp::did_you_mean("--lot", {"--prior-lot", "-o"}),
            " (did you mean '--prior-lot'?)");
}

TEST(Nearest, IsNothingWhereNothingIsNear) {
  EXPECT_EQ(fogcomp::nearest("wavelet", kNames), "");
  EXPECT_EQ(fogcomp::nearest("", kNames), "");
  EXPECT_EQ(fogcomp::nearest(std::string(1U << 20U, 's'), kNames), "");
  EXPECT_EQ(fogcomp::did_you_mean("shup", kNames), " (did you mean 'shupe'?)");
}

}  // namespace
