#include "core/compensation/drift_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "model/drift_model.hpp"
#include "support/overflow_guard.hpp"
#include "support/random_history.hpp"
#include "support/repeats.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::model {
static void PrintTo(const EffectTerm& term, std::ostream* out) {
  *out << term.name;
}
}  // namespace fogcomp::model

namespace {

// Largest |board - double| over this many hours of random history, in deg/h.
double worst_difference(const fogcomp::model::Model& model, std::uint64_t seed, int hours) {
  const fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(model, {200, fog::OutputSelection::kvh, true});
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  fogcomp::model::RealDriftModel real(model, 1);
  // Beyond the trained range too: both must clamp alike.
  fog::test::RandomHistory history(seed, -60, 100);
  double worst = 0;
  for (int block = 0; block < hours * fog::test::repeats(3600, 600); ++block) {
    const auto means = history.next();
    if (block == 0) {
      board.start(means);
      real.start(fogcomp::model::to_real(means));
    } else {
      board.step(means);
      real.step(fogcomp::model::to_real(means));
    }
    worst = std::max(worst, std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph()));
  }
  return worst;
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleOnAnyThermalHistory) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_LE(worst_difference(model, seed, 20), 2.0 / 1024) << "seed " << seed;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForEveryPolynomialOrder) {
  for (int order = 1; order <= 9; ++order) {
    fogcomp::model::Model model = fog::test::paper_like_model();
    model.terms = {{"bias_temperature", {{static_cast<double>(order)}}, {}}};
    for (int k = 0; k < order; ++k) {
      model.terms[0].coefficients_dph.push_back(k % 2 == 0 ? 0.9 : -1.1);
    }
    EXPECT_LE(worst_difference(model, 7, 20), 2.0 / 1024) << "order " << order;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForAMemsSizedDrift) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  for (fogcomp::model::EffectTerm& term : model.terms) {
    for (fogcomp::model::Estimate& coefficient : term.coefficients_dph) coefficient.value *= 20000;
  }
  model.network.amplitude_dph = 2000;
  EXPECT_LE(worst_difference(model, 3, 20), 0.02);  // relative: 1e-6 of 14,000 deg/h
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForEveryInputOfANetwork) {
  const fogcomp::model::RealInput temperature{fog::NetworkInput::temperature, 20, 80, 0};
  const fogcomp::model::RealInput rate{fog::NetworkInput::temperature_rate, 0, 1, 0};
  const fogcomp::model::RealInput fast{fog::NetworkInput::lagged_temperature, 20, 75, 30};
  const fogcomp::model::RealInput slow{fog::NetworkInput::lagged_temperature, 20, 40, 20000};
  const fogcomp::model::RealInput elapsed{fog::NetworkInput::elapsed, 30000, 30000, 0};
  const fogcomp::model::RealInput input_rate{fog::NetworkInput::input_rate, 8.47, 12, 0};
  const fogcomp::model::RealInput second{fog::network_input(fog::Input::temperature2), 20, 80, 0};
  const fogcomp::model::RealInput supply{fog::network_input(fog::Input::supply), 5, 1, 0};
  for (const std::vector<fogcomp::model::RealInput>& inputs :
       {std::vector{temperature, rate, slow}, std::vector{fast, slow, temperature, elapsed},
        std::vector{slow, fast, slow, fast}, std::vector{input_rate, rate}, std::vector{elapsed},
        std::vector{second, supply}}) {
    fogcomp::model::Model model = fog::test::paper_like_model();
    model.min_degc = -60;
    model.max_degc = 100;
    model.network = fog::test::network_of(inputs);
    EXPECT_LE(worst_difference(model, 13, 20), 2.0 / 1024)
        << fogcomp::model::name_of(inputs[0].signal);
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForALinearOutput) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.network.output.activation = fog::Activation::linear;
  EXPECT_LE(worst_difference(model, 17, 20), 2.0 / 1024);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

// Time is the number of a block, not the count of blocks received.
TEST(DriftModel, EffectsOfTimeAreTheSameWhateverTheBlock) {
  for (const fogcomp::model::EffectTerm& term : fog::test::typical_terms()) {
    if (!has(fogcomp::model::info_of(term).needs, fog::Input::elapsed)) continue;
    fogcomp::model::Model model = fog::test::paper_like_model();
    model.network = {};
    model.terms = {term};
    const auto drift_after = [&](double time_s, double block_s) {
      fogcomp::model::RealDriftModel real(model, block_s);
      fogcomp::model::RealBlock block;
      block.elapsed = time_s / block_s;
      real.start(block);
      return real.drift_dph();
    };
    for (const double time_s : {0.0, 100.0, 5000.0, 100000.0}) {
      const double drift_dph = drift_after(time_s, 1);
      EXPECT_NEAR(drift_after(time_s, 0.5), drift_dph, 1e-9) << term.name;
      EXPECT_NEAR(drift_after(time_s, 5), drift_dph, 1e-9) << term.name;
    }
    EXPECT_GT(std::abs(drift_after(100000, 1) - drift_after(0, 1)), 1e-3) << term.name;
  }
}

// A shape at the bounds of the search: the lower one of each parameter, the upper ones, or in turn.
std::vector<double> at_bounds(const fogcomp::model::CatalogueEntry& entry, bool first_upper,
                              bool in_turn) {
  std::vector<double> shape;
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const fogcomp::model::ShapeBounds bounds = fogcomp::model::catalogue_bounds(entry, i);
    const bool upper = first_upper != (in_turn && i % 2 == 1);
    shape.push_back(upper ? bounds.max : bounds.min);
  }
  return shape;
}

// The ends and the middle of what the formats must hold, with and without optional parts.
std::set<std::vector<double>> shapes_of(const fogcomp::model::EffectTerm& example) {
  const fogcomp::model::CatalogueEntry& entry = fogcomp::model::find_effect(example.name);
  return {example.shape(),
          fog::test::natural_term(example.name, {}, {}).shape(),
          at_bounds(entry, false, false),
          at_bounds(entry, true, false),
          at_bounds(entry, false, true),
          at_bounds(entry, true, true)};
}

// The example with another shape: additional coefficients are 1 deg/h.
fogcomp::model::EffectTerm with_shape(fogcomp::model::EffectTerm term,
                                      const std::vector<double>& shape) {
  for (std::size_t i = 0; i < shape.size(); ++i) term.parameters[i].value = shape[i];
  const std::size_t count = fogcomp::model::RegressorBank({term}, 1).size();
  term.coefficients_dph.resize(count, 1);
  return term;
}

class EveryEffect : public testing::TestWithParam<fogcomp::model::EffectTerm> {};

TEST_P(EveryEffect, IsWithinTwoLsbOfDoubleOver72HoursOfAnyThermalHistory) {
  for (const std::vector<double>& shape : shapes_of(GetParam())) {
    fogcomp::model::Model model = fog::test::paper_like_model();
    model.min_degc = -60;
    model.max_degc = 100;
    model.network = {};
    model.terms = {with_shape(GetParam(), shape)};
    const double worst = worst_difference(model, 11, 72);
    EXPECT_LE(worst, 2.0 / 1024) << testing::PrintToString(shape);
    RecordProperty("worst_lsb" + testing::PrintToString(shape), std::to_string(worst * 1024));
    std::printf("  %-26s %-14s %.2f LSB\n", GetParam().name.c_str(),
                testing::PrintToString(shape).c_str(), worst * 1024);
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(fog::test::typical_terms()),
                         [](const auto& test) { return test.param.name; });

TEST(DriftModel, BoardIsWithinFourLsbOfDoubleWithAllEffectsAtOnce) {
  const fogcomp::model::Model model = fog::test::all_effects_model();
  EXPECT_LE(worst_difference(model, 5, 72), 4.0 / 1024);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
