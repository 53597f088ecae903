#include "diagnosis/forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

std::vector<Formula> formulas(fog::InputMask inputs) {
  const model::Model model = fog::test::truth();
  series::SignalSeries series(model);
  series.add(series::make_blocks(fog::test::recording_of(model, fog::test::kQuietNoise, 1)));
  return formulas_over(series, inputs);
}

bool has_text(const std::vector<Formula>& formulas, const std::string& text) {
  return std::any_of(formulas.begin(), formulas.end(), [&](const Formula& formula) {
    return form_text(formula.term.expression->expression) == text;
  });
}

TEST(Forms, AreOfTheSignalsThatVaryAndHaveNamesOfTheirOwn) {
  const std::vector<Formula> found = formulas(~fog::InputMask{0});
  std::set<std::string> names;
  for (const auto& [term, meaning] : found) {
    EXPECT_TRUE(names.insert(term.name).second) << term.name;
    EXPECT_EQ(term.expression->expression.needs() & fog::kAllExtensionInputs, 0U) << term.name;
  }
  for (const char* text :
       {"dTdt^2", "abs(dTdt)", "T^2*dTdt", "T*dTdt^2", "lag(dTdt^2,tau)", "lag(dTdt,tau)^2",
        "abs(lag(dTdt,tau))", "lag(lag(dTdt,tau),tau)^2", "(T-c)^2*dTdt", "max(T-c,0)",
        "highest(T)", "max(highest(T)-c,0)", "sin(6.2832*dTdt/p)", "sin(6.2832*T/p+c)*dTdt"}) {
    EXPECT_TRUE(has_text(found, text)) << text;
  }
  EXPECT_FALSE(has_text(found, "T*dTdt")) << "the catalogue has it";
  EXPECT_FALSE(has_text(found, "W^2")) << "the input rate is 0 here";
}

// A supply that is not quite rejected: no effect of the catalogue is linear in it.
TEST(Forms, HaveAnExtensionInputItself) {
  const model::Model model = fog::test::truth();
  recording::Recording recording = fog::test::recording_of(model, fog::test::kQuietNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording[fog::Input::supply].push_back(5 + 0.1 * std::sin(static_cast<double>(i) / 50));
  }
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  const auto inputs = bit_of(fog::Input::temperature) | bit_of(fog::Input::supply);
  EXPECT_TRUE(has_text(formulas_over(series, inputs), "V"));
  EXPECT_FALSE(has_text(formulas_over(series, inputs), "T"));
  EXPECT_TRUE(has_text(formulas_over(series, inputs), "(T-c)*(V-5)"));
  // Its zero is far away: V^2 would be a straight line.
  EXPECT_TRUE(has_text(formulas_over(series, inputs), "(V-5)^2"));
  EXPECT_FALSE(has_text(formulas_over(series, inputs), "V^2"));
}

TEST(Forms, OfAnInputRateGoWithTimeSincePowerOnAndWithTheTemperature) {
  const model::Model model = fog::test::truth();
  recording::Recording recording = fog::test::recording_of(model, fog::test::kQuietNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.input_rate_dph.push_back(72000 * std::sin(static_cast<double>(i) / 50));
  }
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  const auto inputs = bit_of(fog::Input::temperature) | bit_of(fog::Input::input_rate);
  const std::vector<Formula> found = formulas_over(series, inputs | bit_of(fog::Input::elapsed));
  EXPECT_TRUE(has_text(found, "W*exp(-t/tau)"));
  EXPECT_TRUE(has_text(found, "(T-c)*abs(W)"));
  EXPECT_TRUE(has_text(found, "sin(6.2832*T/p+c)*W"));
  EXPECT_FALSE(has_text(found, "(T-c)*W")) << "the catalogue has it";
  EXPECT_FALSE(has_text(formulas_over(series, inputs), "W*exp(-t/tau)")) << "unknown power-on";
}

TEST(Forms, SayWhichPhysicsGivesThem) {
  for (std::size_t i = 0; i < kFormMeanings.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kFormMeanings[i].meaning), i);
  }
  const auto meaning_of = [found = formulas(~fog::InputMask{0})](const std::string& name) {
    for (const auto& [term, meaning] : found) {
      if (term.name == name) return meaning;
    }
    throw std::runtime_error("no " + name);
  };
  EXPECT_EQ(meaning_of("dTdt_squared"), FormMeaning::squared_rate);
  EXPECT_EQ(meaning_of("dTdt_size"), FormMeaning::one_direction);
  EXPECT_EQ(meaning_of("T_offset_squared_dTdt"), FormMeaning::bent_rate);
  EXPECT_EQ(meaning_of("T_dTdt_squared"), FormMeaning::squared_rate);
  EXPECT_EQ(meaning_of("dTdt_late_squared"), FormMeaning::late);
  EXPECT_EQ(meaning_of("T_kink"), FormMeaning::onset);
  EXPECT_EQ(meaning_of("T_highest"), FormMeaning::first_heat);
}

TEST(Forms, AreShownWithoutBounds) {
  const model::EffectTerm term =
      model::expression_term("x = lag(abs(T-?c[1,20]),?tau[60,6000])*?c");
  EXPECT_EQ(form_text(term.expression->expression), "lag(abs(T-c),tau)*c");
}

}  // namespace
}  // namespace fogcomp::diagnosis
