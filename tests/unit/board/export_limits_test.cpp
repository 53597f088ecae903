#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "board/board_table.hpp"
#include "support/input_error.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::board {
namespace {

std::string refusal(const model::Model& model) {
  try {
    make_board_table(model, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ExportLimits, ACoefficientIsNamedWithItsUnitTheLimitAndTheRemedy) {
  model::Model model = fog::test::paper_like_model();
  model::EffectTerm aging = fog::test::natural_term("aging", {2e6}, {-5.9561e5});
  aging.parameters[0].identified = true;
  aging.parameters[0].sigma = 1;
  model.terms.push_back(aging);
  EXPECT_EQ(refusal(model),
            "effect 'aging': a = -5.9561e+05 deg/h is more than the board's numbers hold, "
            "5.2429e+05 deg/h; `aging`: t0 is at its upper bound 2e+06 s: a line in time would do "
            "as well; fit again without it or with its shape given");
}

TEST(ExportLimits, ATrainedRangeInKelvinIsNamed) {
  model::Model model = fog::test::paper_like_model();
  model.min_degc = 234;
  model.max_degc = 335;
  EXPECT_EQ(refusal(model),
            "export: the trained range 234 to 335 degC lies outside -70 to 130 degC, what a board "
            "has; is temperature_degc in kelvin? subtract 273.15 and fit again");
  model.min_degc = 131;
  model.max_degc = 143;
  EXPECT_EQ(refusal(model),
            "export: the trained range 131 to 143 degC lies outside -70 to 130 degC, what a board "
            "has; is temperature_degc in degC? correct it and fit again");
}

// Full scale and the largest step of a sample, deg/s.
std::pair<double, double> rate_limits(const model::Model& model, const BoardSettings& settings) {
  const BoardTable table = make_board_table(model, settings);
  const fog::RateLimits rate = read_board_table(table, "test").acquisition.rate;
  return {std::ldexp(rate.range.raw(), -10) / 3600, std::ldexp(rate.step.raw(), -9) / 3600};
}

TEST(ExportLimits, TheRateIsJudgedByTheModelsLimitsUnlessOthersAreGiven) {
  model::Model model = fog::test::paper_like_model();
  EXPECT_EQ(rate_limits(model, {}), std::pair(570.0, 100.0));
  model.limits = {200, 2000};
  EXPECT_EQ(rate_limits(model, {}), std::pair(200.0, 10.0));
  EXPECT_EQ(rate_limits(model, {400}), std::pair(200.0, 5.0)) << "of a sample of 2.5 ms";
  BoardSettings given;
  given.limits.range_dps = 300;
  EXPECT_EQ(rate_limits(model, given), std::pair(300.0, 10.0));
  given.limits.max_acceleration_dps2 = 500;
  EXPECT_EQ(rate_limits(model, given), std::pair(300.0, 2.5));
}

// Smallest and largest light power that a board believes, uW, of a gyro trained within a range.
std::pair<double, double> light_limits(double min, double max) {
  model::Model model = fog::test::paper_like_model();
  model.terms.push_back(fog::test::natural_term("light_power", {}, {0.3}));
  model.input_ranges[extension_number(fog::Input::light_power)] = {{min, max}, 1};
  BoardSettings settings;
  settings.extension = true;
  const BoardTable table = make_board_table(model, settings);
  const fog::ModelParameters parameters = read_board_table(table, "test");
  const fog::Span<const std::int32_t> limits = parameters.acquisition.input_limits;
  return {std::ldexp(limits[0], -16), std::ldexp(limits[1], -16)};
}

// The drift follows the logarithm of the light, so its margin is a ratio, and no light at all is a
// fault, whatever was trained. Training that reached 0 has no ratio: half its span, as with other
// inputs. Training at one power has no limit but the least that a record can say.
TEST(ExportLimits, Light_WhateverWasTrained_NoneIsRefused) {
  const double least = std::ldexp(1, -16);
  EXPECT_EQ(light_limits(100, 400), std::pair(50.0, 800.0));
  EXPECT_NEAR(light_limits(1, 400).first, 0.05, 1e-5);
  EXPECT_EQ(light_limits(0, 400), std::pair(least, 600.0));
  EXPECT_EQ(light_limits(-7, 293), std::pair(least, 443.0));
  EXPECT_EQ(light_limits(0, 0).first, least);
  EXPECT_EQ(light_limits(250, 250).first, least);
  EXPECT_THROW(light_limits(-400, -200), InputError) << "a unit or a sign is wrong";
}

}  // namespace
}  // namespace fogcomp::board
