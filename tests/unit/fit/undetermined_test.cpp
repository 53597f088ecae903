#include "fit/undetermined.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using Change = std::function<void(recording::Recording&)>;

// Error message of a fit of these effects to a changed recording of the sample gyro; "" if it
// succeeds.
std::string refusal(const std::string& effects, const std::string& expression = "",
                    const Change& change = {}) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  if (change) change(recording);
  model::Model model = fog::test::model_of(model::parse_effects(effects));
  if (!expression.empty()) model::add_expression(model.terms, expression);
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  try {
    identify(model, series);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void since_1970(recording::Recording& recording) {
  for (double& time_s : recording.time_s) time_s += 1.7e9;
}

void at_rest(recording::Recording& recording) {
  for (double& degc : recording.temperature_degc) degc = 20;
}

TEST(Undetermined, AShapeIsRefusedByItsNameWithTheReasonAndTheRemedy) {
  EXPECT_EQ(refusal("bias,aging", "", since_1970),
            "aging: these recordings do not determine t0 (time_s begins at 1700000000 s: is it "
            "since power-on?); give aging:t0=VALUE or leave the effect out");
}

TEST(Undetermined, CoefficientsAreRefusedByTheirNames) {
  EXPECT_EQ(refusal("bias,bias_temperature,temperature_rate", "", at_rest),
            "bias_temperature: these recordings do not determine b1 and b2, nor temperature_rate's "
            "K (the temperature moves by no more than 0 degC); lower its order or leave the effect "
            "out");
}

void on_earth(recording::Recording& recording) {
  recording.input_rate_dph.assign(recording.rows(), 8.47);
}

TEST(Undetermined, AnErrorOfTheInputRateIsRefusedWhereTheRateDoesNotMove) {
  for (const std::string effect : {"scale_factor", "scale_factor_temperature",
                                   "scale_factor_nonlinearity", "scale_factor_asymmetry"}) {
    EXPECT_EQ(refusal("bias," + effect, "", on_earth),
              effect +
                  ": these recordings do not determine it (input_rate_dph never changes: the "
                  "input rate does not move); leave the effect out");
  }
}

TEST(Undetermined, ACoefficientThatOthersMakeUpIsRefusedWithTheirNames) {
  EXPECT_EQ(refusal("bias,temperature_rate,shupe:tau=120,thermal_lag:tau=120"),
            "thermal_lag: these recordings do not determine K (on these rows it is made up of "
            "temperature_rate's K and shupe's K); leave the effect out");
}

TEST(Undetermined, TheShapeOfAnExpressionIsRefusedByItsName) {
  EXPECT_EQ(refusal("bias", "x = tanh(T / ?w[1e-30, 1e-20])"),
            "expression 'x': these recordings do not determine w; narrow the bounds, write a value "
            "instead or leave the expression out");
}

TEST(Undetermined, AnExpressionThatOverflowsAtSomeOfItsShapesIsFittedAtTheOthers) {
  EXPECT_EQ(refusal("bias", "x = exp(T / ?w[0.01, 1000])"), "");
}

}  // namespace
}  // namespace fogcomp::fit
