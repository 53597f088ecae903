#include "report/page_text.hpp"

#include <gtest/gtest.h>

#include "report/figures.hpp"
#include "report/labels.hpp"

namespace fogcomp::report {
namespace {

TEST(PageText, OurWordsAreTypesetAndNamesAreNot) {
  EXPECT_EQ(Text("0.1 deg/h +- 0.2 degC -> 3 deg/sqrt(h), chi^2").utf8(),
            "0.1 °/h ± 0.2 °C → 3 °/√h, χ²");
  EXPECT_EQ(verbatim("run_degC+-deg/h.csv").utf8(), "run_degC+-deg/h.csv");
  EXPECT_EQ(("at worst, on " + verbatim("run_degC.csv") + ": 1 deg/h").utf8(),
            "at worst, on run_degC.csv: 1 °/h");
}

TEST(PageText, NamesInASentenceComposedElsewhereStay) {
  EXPECT_EQ(words("it sits in hold_degC (40 %): 2 degC", {"hold_degC", ""}).utf8(),
            "it sits in hold_degC (40 %): 2 °C");
}

TEST(PageText, FilesAreCalledByTheirNamesUnlessTwoHaveTheSame) {
  EXPECT_EQ(short_names({"/lab/a.model", "b.model"}),
            (std::vector<std::string>{"a.model", "b.model"}));
  EXPECT_EQ(short_names({"x/gyro.model", "y/gyro.model", "z/other.model"}),
            (std::vector<std::string>{"x/gyro.model", "y/gyro.model", "other.model"}));
}

TEST(Figures, RatesHaveFourSignificantDigitsAndNoMoreThanARecordingHolds) {
  EXPECT_EQ(number(1919.2848).utf8(), "1919");
  EXPECT_EQ(number(144.611).utf8(), "144.6");
  EXPECT_EQ(number(-0.0234912).utf8(), "-0.02349");
  EXPECT_EQ(number(0.00001234).utf8(), "0.000012");
  EXPECT_EQ(number(-1e-9).utf8(), "0");
  EXPECT_EQ(number(12345.6).utf8(), "12346");
  EXPECT_EQ(dph(std::nullopt).utf8(), "-");
}

TEST(Figures, QuantitiesOfAnyUnitHaveFourSignificantDigits) {
  EXPECT_EQ(significant(5955).utf8(), "5955");
  EXPECT_EQ(significant(0).utf8(), "0");
  EXPECT_EQ(significant(-4.5491e-05).utf8(), "-4.549e-05");
  EXPECT_EQ(significant(36.5249).utf8(), "36.52");
}

TEST(Labels, AreForPeopleAndHaveUnits) {
  EXPECT_EQ(variable_label("temperature_degc x temperature_rate").utf8(),
            "temperature × temperature rate");
  EXPECT_EQ(variable_label("input_rate_dph").utf8(), "input rate");
  EXPECT_EQ(input_label(fog::Input::light_power).utf8(), "light power, µW");
  EXPECT_EQ(figure_label("holdout_drift_dph").utf8(), "drift left, holdout, °/h");
  EXPECT_EQ(figure_label("warm_up.tau").utf8(), "warm_up: tau, s");
  EXPECT_TRUE(figure_label("burst.k").empty());
}

}  // namespace
}  // namespace fogcomp::report
