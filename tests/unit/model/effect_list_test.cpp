#include "model/effect_list.hpp"

#include <gtest/gtest.h>

#include "model/catalogue.hpp"
#include "support/input_error.hpp"

namespace fogcomp::model {
namespace {

TEST(EffectList, BlanksMeanNothing) {
  const auto plain = parse_effects("bias,bias_temperature:order=2,thermal_lag:tau=?[60,900]");
  const auto blanks =
      parse_effects(" bias , bias_temperature : order = 2,\tthermal_lag: tau = ? [60, 900]");
  ASSERT_EQ(blanks.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(blanks[i].name, plain[i].name);
    EXPECT_EQ(blanks[i].shape(), plain[i].shape());
    for (std::size_t k = 0; k < plain[i].parameters.size(); ++k) {
      EXPECT_EQ(blanks[i].parameters[k].identified, plain[i].parameters[k].identified);
    }
  }
  EXPECT_EQ(blanks[2].parameters[0].bounds.max, 900);
}

TEST(EffectList, SaysThatAColonIsToBeAComma) {
  try {
    parse_effects("bias,scale_factor_temperature:order=2:lag=?");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "effect 'scale_factor_temperature': needs a comma between its parameters: "
                 "scale_factor_temperature:order=2,lag=?");
  }
}

TEST(EffectList, RefinementsFreeWhatAFormulaLeavesOutOrKeeps) {
  using Settings = std::vector<std::string>;
  const auto of = [](const char* effect) { return possible_refinements(parse_effects(effect)[0]); };
  EXPECT_EQ(of("polarization_ripple"), (Settings{"period2=?", "chirp=?"}));
  EXPECT_EQ(of("polarization_ripple:period2=5"), (Settings{"period2=?", "chirp=?"}));
  EXPECT_EQ(of("polarization_ripple:period2=?,chirp=0.05"), Settings{"chirp=?"});
  EXPECT_EQ(of("polarization_ripple:period2=?,chirp=?"), Settings{});
  EXPECT_EQ(of("thermal_hysteresis"), Settings{"radius2=?"});
  EXPECT_EQ(of("scale_factor_asymmetry"), Settings{"dead_band=?"});
  EXPECT_EQ(of("scale_factor_temperature"), (Settings{"order=3", "lag=?"}));
  EXPECT_EQ(of("bias_temperature:order=2"), Settings{"order=4"});
  EXPECT_EQ(of("bias_temperature:order=8"), Settings{"order=9"});
  EXPECT_EQ(of("glass_transition"), Settings{"lag=?"});
  for (const char* const has_none :
       {"bias", "bias_temperature:order=9", "thermal_lag:tau=300", "bias_step"}) {
    EXPECT_EQ(of(has_none), Settings{}) << has_none;
  }
  EXPECT_EQ(possible_refinements(expression_term("x = sin(T / ?p[2,60])")), Settings{});
}

TEST(EffectList, HasAFreeNameForAFurtherTerm) {
  std::vector<EffectTerm> terms = parse_effects("bias");
  EXPECT_EQ(free_name(terms, "x"), "x");
  add_expression(terms, "x = T^2");
  EXPECT_EQ(free_name(terms, "x"), "x_2");
  add_expression(terms, "x_2 = T^3");
  EXPECT_EQ(free_name(terms, "x"), "x_3");
}

}  // namespace
}  // namespace fogcomp::model
