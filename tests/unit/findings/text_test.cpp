#include "findings/text.hpp"

#include <gtest/gtest.h>

namespace fogcomp::findings {
namespace {

TEST(Text, OurWordsAreTypesetAndNamesAreNot) {
  EXPECT_EQ(Text("0.1 deg/h +- 0.2 degC -> 3 deg/sqrt(h), chi^2").typeset(),
            "0.1 °/h ± 0.2 °C → 3 °/√h, χ²");
  EXPECT_EQ(verbatim("run_degC+-deg/h.csv").typeset(), "run_degC+-deg/h.csv");
  EXPECT_EQ(("at worst, on " + verbatim("run_degC.csv") + ": 1 deg/h").typeset(),
            "at worst, on run_degC.csv: 1 °/h");
}

TEST(Text, NamesInASentenceComposedElsewhereStay) {
  EXPECT_EQ(words("it sits in hold_degC (40 %): 2 degC", {"hold_degC", ""}).typeset(),
            "it sits in hold_degC (40 %): 2 °C");
}

TEST(Text, QuotesWhatOneTypes) {
  EXPECT_EQ(Text("record `long_soak`, or `reversed`").typeset(),
            "record ‘long_soak’, or ‘reversed’");
  EXPECT_EQ(Text("record `long_soak`").plain(), "record `long_soak`");
}

TEST(Text, OnATerminalStaysInAscii) {
  EXPECT_EQ(Text("sqrt(std^2 - floor^2), 0.1 deg/h").plain(), "sqrt(std^2 - floor^2), 0.1 deg/h");
  EXPECT_EQ(Text("sqrt(std^2 - floor^2), 0.1 deg/h").typeset(), "√(std² − floor²), 0.1 °/h");
}

TEST(Text, AsASentenceHasACapitalUnlessANameBeginsIt) {
  EXPECT_EQ(Text("it moves 1 degC").sentence(), "It moves 1 °C.");
  EXPECT_EQ((verbatim("gyro.model") + ": it moves.").sentence(), "gyro.model: it moves.");
  EXPECT_EQ(words("burst is missing", {"burst"}).sentence(), "burst is missing.");
  EXPECT_EQ(Text().sentence(), "");
}

TEST(Text, FilesAreCalledByTheirNamesUnlessTwoHaveTheSame) {
  EXPECT_EQ(short_names({"/lab/a.model", "b.model"}),
            (std::vector<std::string>{"a.model", "b.model"}));
  EXPECT_EQ(short_names({"x/gyro.model", "y/gyro.model", "z/other.model"}),
            (std::vector<std::string>{"x/gyro.model", "y/gyro.model", "other.model"}));
}

TEST(Figures, RatesHaveFourSignificantDigitsAndNoMoreThanARecordingHolds) {
  EXPECT_EQ(number(1919.2848).typeset(), "1919");
  EXPECT_EQ(number(144.611).typeset(), "144.6");
  EXPECT_EQ(number(-0.0234912).typeset(), "-0.02349");
  EXPECT_EQ(number(0.00001234).typeset(), "0.000012");
  EXPECT_EQ(number(-1e-9).typeset(), "0");
  EXPECT_EQ(number(12345.6).typeset(), "12346");
  EXPECT_EQ(dph(std::nullopt).typeset(), "-");
}

TEST(Figures, QuantitiesOfAnyUnitHaveFourSignificantDigits) {
  EXPECT_EQ(significant(5955).typeset(), "5955");
  EXPECT_EQ(significant(0).typeset(), "0");
  EXPECT_EQ(significant(-4.5491e-05).typeset(), "-4.549e-05");
  EXPECT_EQ(significant(36.5249).typeset(), "36.52");
}

TEST(Labels, AreForPeopleAndHaveUnits) {
  EXPECT_EQ(variable_label("temperature_degc x temperature_rate").typeset(),
            "temperature × temperature rate");
  EXPECT_EQ(variable_label("input_rate_dph").typeset(), "input rate");
  EXPECT_EQ(input_label(fog::Input::light_power).typeset(), "light power, µW");
  EXPECT_EQ(figure_label("holdout_drift_dph").typeset(), "drift left, holdout, °/h");
  EXPECT_EQ(figure_label("warm_up.tau").typeset(), "warm_up: tau, s");
  EXPECT_TRUE(figure_label("burst.k").empty());
}

}  // namespace
}  // namespace fogcomp::findings
