// Time for which a held drift is as good as the model.
#include "board/table_parts.hpp"

#include <gtest/gtest.h>

#include "board/board_table.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::board {
namespace {

// 0.01 deg/h/degC, trained with up to 3 degC/min: the drift changes by 0.0005 deg/h in a second.
model::Model model_of(double residual_rms_dph) {
  model::Model model = fog::test::paper_like_model();
  model.terms = {fog::test::natural_term("bias", {}, {0.7}),
                 fog::test::natural_term("bias_temperature", {1}, {0.01})};
  model.network = {};
  model.residual_rms_dph = residual_rms_dph;
  model.rate_range_degc_per_min = model::Range{-1, 3};
  return model;
}

TEST(HeldAccuracy, LastsUntilTheFastestTrainedRampIsWorthTheResidual) {
  EXPECT_EQ(accurate_hold_blocks(model_of(0.00501), 1, 60), 10U);
  EXPECT_EQ(accurate_hold_blocks(model_of(0.00501), 2, 30), 5U);
  EXPECT_EQ(accurate_hold_blocks(model_of(0.0004), 1, 60), 0U);
  EXPECT_EQ(accurate_hold_blocks(model_of(1), 1, 60), 60U) << "as long as it is held";
}

TEST(HeldAccuracy, CountsWhatABeginningRampDoesToARateTerm) {
  model::Model model = model_of(0.05);
  model.terms[1] = fog::test::natural_term("temperature_rate", {}, {0.3});
  // 0.9 deg/h behind two lags of 30 s: at most 0.9 / 30 / e a second.
  EXPECT_EQ(accurate_hold_blocks(model, 1, 60), 4U);
}

TEST(HeldAccuracy, IsNotKnownOfAModelThatKnowsNoRamps) {
  model::Model model = model_of(0.0004);
  model.rate_range_degc_per_min.reset();
  EXPECT_EQ(accurate_hold_blocks(model, 1, 60), 60U);
}

// A field may be anywhere in its trained range at once: 0.005 deg/h/uT over 2 or 0.02 uT.
TEST(HeldAccuracy, InputThatMayLeap_ItsWholeRangeCounts) {
  model::Model model = model_of(0.00501);
  model.terms.push_back(fog::test::natural_term("magnetic", {}, {0.005, 0}));
  auto& field = model.input_ranges[extension_number(fog::Input::magnetic)];
  field = {{-1, 1}, 0.1};
  EXPECT_EQ(accurate_hold_blocks(model, 1, 60), 0U);
  field = {{-0.01, 0.01}, 0.001};
  EXPECT_EQ(accurate_hold_blocks(model, 1, 60), 9U) << "0.0001 of 0.005 deg/h are the field's";
}

// 2 deg/h per degC/min in a ramp of 3: 0.12 deg/h at 2 %, and a tenth more while the derivative's
// lags settle.
TEST(SampleRatePart, RateTerm_ErrorOfTheResidual) {
  model::Model model = model_of(0.05);
  model.terms[1] = fog::test::natural_term("temperature_rate", {}, {2});
  EXPECT_NEAR(sample_rate_part(model, 1), 50 * 1.1 * 0.12 / 0.05, 2);
  model.residual_rms_dph = 0.14;
  EXPECT_EQ(sample_rate_part(model, 1), 50U);
  model.residual_rms_dph = 0;
  EXPECT_EQ(sample_rate_part(model, 1), 200U) << "what a board can measure";
}

TEST(SampleRatePart, NoTermOfTime_TwoPercent) {
  EXPECT_EQ(sample_rate_part(model_of(0.001), 1), 50U);
  model::Model model = model_of(0);
  model.rate_range_degc_per_min.reset();
  EXPECT_EQ(sample_rate_part(model, 1), 50U);
}

TEST(HeldAccuracy, IsInTheTableOfTheBoard) {
  const BoardTable table = make_board_table(model_of(0.00501), {});
  EXPECT_EQ(read_board_table(table, "test").policy.accurate_blocks, 10U);
}

}  // namespace
}  // namespace fogcomp::board
