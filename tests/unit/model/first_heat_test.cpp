// highest(T): what a coil's first heat leaves behind.
#include <gtest/gtest.h>

#include <vector>

#include "board/board_table.hpp"
#include "board/verification.hpp"
#include "model/drift_model.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::model {
namespace {

constexpr double kBlockS = 1;

fog::Signals<RealNumbers> at(double degc) {
  fog::Signals<RealNumbers> signals;
  signals.temperature = degc;
  return signals;
}

Model model_of(const std::vector<EffectTerm>& terms) {
  Model model = fog::test::paper_like_model();
  model.network = {};
  model.terms = terms;
  model.max_degc = 60;
  return model;
}

EffectTerm term_of(const std::string& text) {
  EffectTerm term = fog::test::written_term("first_heat = " + text);
  term.coefficients_dph = {0.5};
  return term;
}

TEST(FirstHeat, IsTheLargestTemperatureSinceTheRecordingBeganWhateverTheRestarts) {
  EffectTerm term = term_of("highest(T)");
  term.expression->scale_log2 = 0;
  const auto effect = make_effect(term, kBlockS);
  effect->reset(at(20));
  const auto next = [&](double degc) {
    double value = 0;
    effect->step(at(degc), &value);
    return value;
  };
  EXPECT_EQ(next(-40), 20);
  EXPECT_EQ(next(35), 35);
  EXPECT_EQ(next(10), 35);
  effect->reset(at(25));  // power on again
  EXPECT_EQ(next(25), 35);
  EXPECT_EQ(next(50), 50);
}

TEST(FirstHeat, IsBehindABoardAndAPartOfItsBias) {
  const EffectTerm first_heat = term_of("max(highest(T)-30,0)");
  const double left_dph = 0.5 * std::ldexp(30, -first_heat.expression->scale_log2);
  const Model with_bias =
      board::board_model(model_of({fog::test::natural_term("bias", {}, {0.1}), first_heat}));
  ASSERT_EQ(with_bias.terms.size(), 1U);
  EXPECT_DOUBLE_EQ(with_bias.terms[0].coefficients_dph[0].value, 0.1 + left_dph);
  const Model alone = board::board_model(model_of({first_heat}));
  ASSERT_EQ(alone.terms.size(), 1U);
  EXPECT_EQ(alone.terms[0].name, "bias");
  EXPECT_DOUBLE_EQ(alone.terms[0].coefficients_dph[0].value, left_dph);
}

TEST(FirstHeat, LeavesWhatElseTheExpressionDependsOn) {
  const Model model =
      model_of({fog::test::natural_term("bias", {}, {0.1}), term_of("highest(T)*dTdt")});
  const Model on_board = board::board_model(model);
  ASSERT_EQ(on_board.terms.size(), 2U);
  EXPECT_DOUBLE_EQ(on_board.terms[0].coefficients_dph[0].value, 0.1);
  const auto table = board::make_board_table(model, {200, fog::OutputSelection::kvh, false});
  const auto error = board::verify_quantization(model, board::read_board_table(table, "test"));
  EXPECT_LE(error.worst_dph, board::kQuantizationLimitDph);
}

}  // namespace
}  // namespace fogcomp::model
