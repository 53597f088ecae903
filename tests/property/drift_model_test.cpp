#include "core/compensation/drift_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model/drift_model.hpp"
#include "support/overflow_guard.hpp"
#include "support/random_history.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"

namespace {

// Largest |board - double| over so many hours of random history, in deg/h.
double worst_difference(const fogcomp::Model& model, std::uint64_t seed, int hours) {
  const fogcomp::BoardTable table =
      fogcomp::make_board_table(model, {200, fog::OutputSelection::kvh, true});
  const fog::ModelParameters parameters = fogcomp::read_board_table(table, "test");
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  fogcomp::RealDriftModel real(model, 1);
  // Beyond the trained range too: both must clamp alike.
  fog::test::RandomHistory history(seed, -60, 100);
  double worst = 0;
  for (int block = 0; block < hours * 3600; ++block) {
    const auto means = history.next();
    if (block == 0) {
      board.start(means);
      real.start(fogcomp::to_real(means));
    } else {
      board.step(means);
      real.step(fogcomp::to_real(means));
    }
    worst = std::max(worst, std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph()));
  }
  return worst;
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleOnAnyThermalHistory) {
  fogcomp::Model model = fog::test::paper_like_model();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_LE(worst_difference(model, seed, 20), 2.0 / 1024) << "seed " << seed;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForEveryPolynomialOrder) {
  for (int order = 1; order <= 9; ++order) {
    fogcomp::Model model = fog::test::paper_like_model();
    model.terms = {{"bias_temperature", {static_cast<double>(order)}, {false}, {0}, {}, {}}};
    for (int k = 0; k < order; ++k) {
      model.terms[0].coefficients_dph.push_back(k % 2 == 0 ? 0.9 : -1.1);
      model.terms[0].sigma_dph.push_back(0);
    }
    EXPECT_LE(worst_difference(model, 7, 20), 2.0 / 1024) << "order " << order;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForAMemsSizedDrift) {
  fogcomp::Model model = fog::test::paper_like_model();
  for (fogcomp::EffectTerm& term : model.terms) {
    for (double& coefficient : term.coefficients_dph) coefficient *= 20000;
  }
  model.network.amplitude_dph = 2000;
  EXPECT_LE(worst_difference(model, 3, 20), 0.02);  // relative: 1e-6 of 14,000 deg/h
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForEveryInputOfANetwork) {
  const fogcomp::RealInput temperature{fog::NetworkInput::temperature, 20, 80, 0};
  const fogcomp::RealInput rate{fog::NetworkInput::temperature_rate, 0, 1, 0};
  const fogcomp::RealInput fast{fog::NetworkInput::lagged_temperature, 20, 75, 30};
  const fogcomp::RealInput slow{fog::NetworkInput::lagged_temperature, 20, 40, 20000};
  const fogcomp::RealInput elapsed{fog::NetworkInput::elapsed, 30000, 30000, 0};
  const fogcomp::RealInput input_rate{fog::NetworkInput::input_rate, 8.47, 12, 0};
  const fogcomp::RealInput second{fog::network_input(fog::Input::temperature2), 20, 80, 0};
  const fogcomp::RealInput supply{fog::network_input(fog::Input::supply), 5, 1, 0};
  for (const std::vector<fogcomp::RealInput>& inputs :
       {std::vector{temperature, rate, slow}, std::vector{fast, slow, temperature, elapsed},
        std::vector{slow, fast, slow, fast}, std::vector{input_rate, rate}, std::vector{elapsed},
        std::vector{second, supply}}) {
    fogcomp::Model model = fog::test::paper_like_model();
    model.least_degc = -60;
    model.most_degc = 100;
    model.network = fog::test::network_of(inputs);
    EXPECT_LE(worst_difference(model, 13, 20), 2.0 / 1024) << fogcomp::name_of(inputs[0].signal);
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForALinearOutput) {
  fogcomp::Model model = fog::test::paper_like_model();
  model.network.output.activation = fog::Activation::linear;
  EXPECT_LE(worst_difference(model, 17, 20), 2.0 / 1024);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

// Time is what a block counts, not how many there were.
TEST(DriftModel, EffectsOfTimeAreTheSameWhateverTheBlock) {
  for (const fogcomp::EffectTerm& term : fog::test::typical_terms()) {
    if (term.name != "warm_up" && term.name != "aging") continue;
    fogcomp::Model model = fog::test::paper_like_model();
    model.network = {};
    model.terms = {term};
    const auto drift_after = [&](double time_s, double block_s) {
      fogcomp::RealDriftModel real(model, block_s);
      fogcomp::RealBlock block;
      block.elapsed = time_s / block_s;
      real.start(block);
      return real.drift_dph();
    };
    for (const double time_s : {0.0, 100.0, 5000.0, 100000.0}) {
      const double drift_dph = drift_after(time_s, 1);
      EXPECT_NEAR(drift_after(time_s, 0.5), drift_dph, 1e-9) << term.name;
      EXPECT_NEAR(drift_after(time_s, 5), drift_dph, 1e-9) << term.name;
    }
    EXPECT_GT(std::abs(drift_after(5000, 1) - drift_after(0, 1)), 1e-3) << term.name;
  }
}

// One effect alone; where its shape matters to the formats, at the ends and in the middle of its
// bounds.
struct EffectCase {
  fogcomp::EffectTerm term;
  std::vector<std::vector<double>> shapes;
};
void PrintTo(const EffectCase& effect, std::ostream* out) {
  *out << effect.term.name;
}

std::vector<EffectCase> effect_cases() {
  const std::map<std::string, std::vector<std::vector<double>>> kShapes{
      {"shupe", {{10}, {120}, {20000}}},
      {"thermal_lag", {{10}, {960}, {20000}}},
      {"axial_gradient", {{5}, {30}, {600}}},
      {"polarization_ripple", {{2, 60, 0}, {13, 4.8, 0.05}, {60, 2, -0.2}, {2, 2, 0.2}}},
      {"thermal_hysteresis", {{0.5, 40}, {3, 10}, {40, 7.3}}},
      {"glass_transition", {{-60, 0.5}, {-20, 4}, {80, 20}}},
      {"warm_up", {{10}, {1200}, {100000}}},
      {"aging", {{60}, {3600}, {2000000}}}};
  std::vector<EffectCase> cases;
  for (const fogcomp::EffectTerm& term : fog::test::typical_terms()) {
    const auto shapes = kShapes.find(term.name);
    if (shapes != kShapes.end()) {
      cases.push_back({term, shapes->second});
    } else {
      cases.push_back({term, {term.parameters}});
    }
  }
  return cases;
}

class EveryEffect : public testing::TestWithParam<EffectCase> {};

TEST_P(EveryEffect, IsWithinTwoLsbOfDoubleOver72HoursOfAnyThermalHistory) {
  const EffectCase& effect = GetParam();
  for (const std::vector<double>& shape : effect.shapes) {
    fogcomp::Model model = fog::test::paper_like_model();
    model.least_degc = -60;
    model.most_degc = 100;
    model.network = {};
    model.terms = {effect.term};
    model.terms[0].parameters = shape;
    const double worst = worst_difference(model, 11, 72);
    EXPECT_LE(worst, 2.0 / 1024) << testing::PrintToString(shape);
    RecordProperty("worst_lsb" + testing::PrintToString(shape), std::to_string(worst * 1024));
    std::printf("  %-26s %-14s %.2f LSB\n", effect.term.name.c_str(),
                testing::PrintToString(shape).c_str(), worst * 1024);
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(effect_cases()),
                         [](const auto& test) { return test.param.term.name; });

TEST(TypicalTerms, HaveEveryEffectThatABoardCanHave) {
  for (const fogcomp::CatalogueEntry& entry : fogcomp::catalogue()) {
    if (entry.description.host_only != nullptr) continue;
    const auto terms = fog::test::typical_terms();
    EXPECT_TRUE(std::any_of(
        terms.begin(), terms.end(),
        [&](const fogcomp::EffectTerm& term) { return term.name == entry.description.name; }))
        << "Add " << entry.description.name
        << " at its usual size to typical_terms() in tests/support/typical_effects.hpp.";
  }
}

TEST(DriftModel, BoardIsWithinFourLsbOfDoubleWithAllEffectsAtOnce) {
  const fogcomp::Model model = fog::test::all_effects_model();
  EXPECT_LE(worst_difference(model, 5, 72), 4.0 / 1024);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
