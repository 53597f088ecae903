// Time for which a board reports settling lags after a start.
#include "board/delays.hpp"

#include <gtest/gtest.h>

#include "support/typical_effects.hpp"

namespace fogcomp::board {
namespace {

using fog::test::natural_term;

model::Model model_of(const std::vector<model::EffectTerm>& terms) {
  model::Model model = fog::test::paper_like_model();
  model.terms = terms;
  return model;
}

TEST(SettlingTime, IsThatOfTheDerivativeWhereNothingIsBehindIt) {
  EXPECT_EQ(settling_time_s(fog::test::paper_like_model()), 7 * 30);
  EXPECT_EQ(settling_time_s(model_of({natural_term("thermal_hysteresis", {3}, {1})})), 7 * 30);
}

TEST(SettlingTime, IsAsLongAsTheSlowestLag) {
  const auto slow = natural_term("thermal_lag", {960}, {1});
  const auto slower = natural_term("shupe", {20000}, {1});
  EXPECT_EQ(settling_time_s(model_of({slow})), 7 * 30 + 5 * 960);
  EXPECT_EQ(settling_time_s(model_of({slower, slow})), 7 * 30 + 5 * 20000);
  EXPECT_EQ(settling_time_s(model_of({natural_term("axial_gradient", {100}, {1, 1})})),
            7 * 30 + 5 * 100);
  EXPECT_EQ(settling_time_s(model_of({fog::test::written_term("a = lag(T,300)-lag(T,70)")})),
            7 * 30 + 5 * 300);
  EXPECT_EQ(settling_time_s(model_of({natural_term("glass_transition", {10, 4, 1200}, {1, 1})})),
            7 * 30 + 5 * 1200);
  model::Model network = fog::test::paper_like_model();
  network.network.inputs.push_back({fog::NetworkInput::lagged_temperature, 20, 40, 4000});
  EXPECT_EQ(settling_time_s(network), 7 * 30 + 5 * 4000);
}

// A lag of a lag begins to settle when the inner one has.
TEST(SettlingTime, OfNestedLags_IsTheirSum) {
  const auto nested = [](const char* text) {
    return settling_time_s(model_of({fog::test::written_term(text)}));
  };
  EXPECT_EQ(nested("a = lag(lag(T,300),400)-T"), 7 * 30 + 5 * 700);
  EXPECT_EQ(nested("a = lag(lag(T,300)-lag(T,500),400)"), 7 * 30 + 5 * 900);
  EXPECT_EQ(nested("a = lag(T*lag(lag(T,10),20),30)+lag(T,50)"), 7 * 30 + 5 * 60);
  EXPECT_EQ(nested("a = lag(lag(T,10),20)+lag(T,50)"), 7 * 30 + 5 * 50);
}

TEST(SettlingTime, IsNotThatOfATimeWithoutAState) {
  EXPECT_EQ(settling_time_s(model_of({natural_term("warm_up", {1200}, {1})})), 7 * 30);
  EXPECT_EQ(
      settling_time_s(model_of({natural_term("scale_factor_temperature", {1, 20, 240}, {1})})),
      7 * 30);
}

TEST(SettlingTime, OfALag_IsSaid) {
  EXPECT_EQ(settling_words(fog::test::paper_like_model()), "");
  EXPECT_EQ(settling_words(model_of({natural_term("thermal_lag", {604}, {1})})),
            "no rate is valid for the first 3230 s after power-on, until the lags of thermal_lag "
            "have settled (export --invalid chooses what makes a rate invalid)");
}

TEST(SettlingTime, IsInTheTableOfTheBoard) {
  const model::Model model = model_of({natural_term("thermal_lag", {300}, {1})});
  const BoardTable table = make_board_table(model, {200});
  EXPECT_EQ(read_board_table(table, "test").policy.settle_blocks, 210U + 1500);
}

}  // namespace
}  // namespace fogcomp::board
