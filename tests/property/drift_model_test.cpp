#include "core/compensation/drift_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/drift_model.hpp"
#include "support/overflow_guard.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::Temperature;

// A thermal history out of soaks, ramps, steps and noise, each drawn at random.
class RandomHistory {
 public:
  RandomHistory(std::uint64_t seed, double least, double most)
      : random_(seed), least_(least), most_(most), temperature_(uniform(least, most)) {}

  Temperature next() {
    if (left_-- <= 0) begin_part();
    temperature_ = std::min(most_, std::max(least_, temperature_ + per_block_));
    const double noisy = temperature_ + noise_ * normal_(random_);
    return Temperature::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(noisy, 16))));
  }

 private:
  void begin_part() {
    left_ = static_cast<int>(uniform(10, 1200));
    noise_ = uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.06);
    const double kind = uniform(0, 1);
    per_block_ = 0;
    if (kind < 0.5) per_block_ = uniform(-10, 10) / 60;
    if (kind > 0.9) temperature_ = uniform(least_, most_);
  }
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double least_;
  double most_;
  double temperature_;
  double per_block_ = 0;
  double noise_ = 0;
  int left_ = 0;
};

// Largest |board - double| over 20 h of random history, in deg/h.
double worst_difference(const fogcomp::Model& model, std::uint64_t seed) {
  const fogcomp::BoardTable table = fogcomp::make_board_table(model, {});
  const fog::ModelParameters parameters = fogcomp::read_board_table(table, "test");
  fog::DriftModel<fog::kAllEffects> board(parameters.thermal, parameters.effects,
                                          parameters.network, parameters.policy);
  fogcomp::RealDriftModel real(model, 1);
  // Beyond the trained range too: both must clamp alike.
  RandomHistory history(seed, -60, 100);
  double worst = 0;
  for (int block = 0; block < 72000; ++block) {
    const Temperature temperature = history.next();
    const double degc = std::ldexp(temperature.raw(), -16);
    if (block == 0) {
      board.start({temperature});
      real.start({degc});
    } else {
      board.step({temperature});
      real.step({degc});
    }
    worst = std::max(worst, std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph()));
  }
  return worst;
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleOnAnyThermalHistory) {
  fogcomp::Model model = fog::test::paper_like_model();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_LE(worst_difference(model, seed), 2.0 / 1024) << "seed " << seed;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForEveryPolynomialOrder) {
  for (int order = 1; order <= 9; ++order) {
    fogcomp::Model model = fog::test::paper_like_model();
    model.terms = {{"bias_temperature", {static_cast<double>(order)}, {}, {}}};
    for (int k = 0; k < order; ++k) {
      model.terms[0].coefficients_dph.push_back(k % 2 == 0 ? 0.9 : -1.1);
      model.terms[0].sigma_dph.push_back(0);
    }
    EXPECT_LE(worst_difference(model, 7), 2.0 / 1024) << "order " << order;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(DriftModel, BoardIsWithinTwoLsbOfDoubleForAMemsSizedDrift) {
  fogcomp::Model model = fog::test::paper_like_model();
  for (fogcomp::EffectTerm& term : model.terms) {
    for (double& coefficient : term.coefficients_dph) coefficient *= 20000;
  }
  model.network.amplitude_dph = 2000;
  EXPECT_LE(worst_difference(model, 3), 0.02);  // relative: 1e-6 of 14,000 deg/h
}

}  // namespace
