#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/compensation/drift_model.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "support/overflow_guard.hpp"
#include "support/repeats.hpp"
#include "support/typical_effects.hpp"

// Why nothing drifts over 10^8 blocks (three years), or any number. An effect is one of three
// kinds:
//  * without state (polynomials, ripple, glass transition, field...): nothing to drift;
//  * a function of the block count (warm_up): exact integer time, computed anew each block;
//  * with state: play operators, whose clamp is exact and idempotent, first-order lags, and the
//    age of aging, a sum of whole blocks, each rounded once where q10 is not 1.
// A lag's update y' = y + round(decay * round(x - y)) is for constant x a map of y alone. It moves
// y towards x, never past it, and by nothing once |x - y| < 2^-23 or so: from there y is a fixed
// point, and a fixed point of a deterministic map stays for ever. For x that varies, the update
// contracts
// (|decay| < 1), so that a rounding error of one block decays like every other difference: the sum
// of all is bounded by the worst single one over the decay, not by the number of blocks. The tests
// below visit the fixed points; FirstOrderLag's own tests show the bound.
namespace {

using Lag = fog::FirstOrderLag<fog::BoardNumbers>;

Lag::Decay decay_of(double tau_blocks) {
  return Lag::Decay::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(-std::expm1(-1 / tau_blocks), 31))));
}

TEST(LongRun, ALagEndsInAFixedPointBesideItsInputFromBothSides) {
  constexpr std::int64_t kNear = std::int64_t{1} << 18;  // 2^-22 of a degree
  std::mt19937_64 random(1);
  for (const double tau : {2.0, 30.0, 960.0, 20000.0, 100000.0}) {
    for (int i = 0; i < 6; ++i) {
      const auto x = Lag::State::from_raw(static_cast<std::int64_t>(random() >> 18U));
      const std::int64_t start = (i % 2 == 0 ? 1 : -1) * (kNear * 8 + i * 12345);
      Lag lag(decay_of(tau));
      lag.reset(Lag::State::from_raw(x.raw() + start));
      Lag::State last{};
      int blocks = 0;
      for (const int max = static_cast<int>(8 * tau) + 8; blocks < max; ++blocks) {
        last = lag.value();
        const Lag::State next = lag.step(x);
        if (next == last) break;
        // Towards x, never past it.
        ASSERT_EQ(next<last, start> 0);
        ASSERT_LE(std::abs((next - x).raw()), std::abs((last - x).raw()));
      }
      ASSERT_EQ(lag.step(x), last) << "tau " << tau;
      EXPECT_LE(std::abs((last - x).raw()), kNear) << "tau " << tau;
    }
  }
}

TEST(LongRun, ALagDoesNotWanderUnderSensorNoise) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 0.06);
  Lag lag(decay_of(960));
  const auto at = [](double degc) {
    return Lag::State::from_raw(std::llround(std::ldexp(std::lround(degc * 65536), 24)));
  };
  lag.reset(at(25));
  for (int block = 0; block < 3000000; ++block) lag.step(at(25 + noise(random)));
  // The lag's own noise is 0.06 sqrt(1 / 1920) = 0.0014 degC.
  EXPECT_NEAR(std::ldexp(static_cast<double>(lag.value().raw()), -40), 25, 5 * 0.0014);
}

TEST(LongRun, EveryEffectStandsStillAtConstantInputs) {
  const fogcomp::model::Model model = fog::test::all_effects_model();
  const fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(model, {200, fog::OutputSelection::kvh, true});
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  fog::BlockMeans<fog::BoardNumbers> block;
  block.temperature = fog::Temperature::from_raw(1234567);
  block.elapsed = fog::Elapsed::highest();
  block.extension.fill(fog::ExtensionValue::from_raw(1300000));
  board.start(block);
  for (int i = 0; i < 100; ++i) {  // an excursion, so that every state has something to forget
    block.temperature = fog::Temperature::from_raw(1234567 + 10000 * i);
    board.step(block);
  }
  for (int i = 0; i < 60000; ++i) board.step(block);
  const fog::Rate settled = board.drift();
  for (int i = 0; i < fog::test::repeats(500000, 20000); ++i) {
    board.step(block);
    ASSERT_EQ(board.drift(), settled) << i;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
