#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "board/table_parts.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/thermal/thermal_state.hpp"
#include "model/drift_model.hpp"
#include "support/input_error.hpp"
#include "support/overflow_guard.hpp"
#include "support/random_history.hpp"
#include "support/sample_models.hpp"

namespace {

using fogcomp::model::EffectTerm;

// Signal ranges as from a fit to these histories, but narrower, so that the clamps are tested too.
void set_ranges(EffectTerm& term) {
  const auto set = [&](fog::Input signal, double min, double max) {
    term.expression->ranges[static_cast<std::size_t>(signal)] = {min, max};
  };
  set(fog::Input::temperature, -50, 90);
  set(fog::Input::temperature_rate, -32, 32);
  set(fog::Input::elapsed, 0, 60000);
  set(fog::Input::input_rate, -100, 100);
  set(fog::Input::temperature2, -55, 95);
  set(fog::Input::magnetic, -300, 300);
  set(fog::Input::light_power, 0, 4000);
  set(fog::Input::supply, 4.2, 5.9);
  set(fog::Input::vibration, 0, 18);
}

struct Outcome {
  double bound = 0;
  double worst = 0;
};

// Board against double over a random history, both fed with the same blocks.
Outcome run(const EffectTerm& term, std::uint64_t seed, int blocks) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.terms.push_back(term);
  const fogcomp::board::ExpressionCode code = fogcomp::board::compile_expression(term, model, 1);
  const std::int32_t one = 1 << 10;
  fog::ExpressionParameters parameters{{code.words.data(), code.words.size()}, {&one, 1}, 0};
  EXPECT_TRUE(fog::expressions_fit(parameters));
  fog::ExpressionBank<fog::kAllExpressions> board(parameters, 10);

  const fogcomp::board::BoardTable table = fogcomp::board::make_board_table(
      fog::test::paper_like_model(), {200, fog::OutputSelection::kvh, true});
  fog::ThermalState<fog::BoardNumbers> board_thermal(
      fogcomp::board::read_board_table(table, "test").thermal);
  fog::ThermalState<fogcomp::model::RealNumbers> real_thermal(
      fogcomp::model::thermal_parameters(model, 1));
  const auto real = fogcomp::model::make_effect(term, 1);
  fog::test::RandomHistory history(seed, -60, 100);
  Outcome outcome{code.error, 0};
  for (int i = 0; i < blocks; ++i) {
    const auto means = history.next();
    const fogcomp::model::RealBlock real_means = fogcomp::model::to_real(means);
    if (i == 0) {
      board.reset(board_thermal.reset(means));
      real->reset(real_thermal.reset(real_means));
    }
    board.step(board_thermal.step(means));
    double expected = 0;
    real->step(real_thermal.step(real_means), &expected);
    expected = std::clamp(expected, -8.0, 8.0);
    const double got = std::ldexp(board.regressors()[0].raw(), -28);
    outcome.worst = std::max(outcome.worst, std::abs(got - expected));
  }
  return outcome;
}

// An expression scaled so that its regressor stays about the board's range.
EffectTerm term_of(const std::string& text) {
  EffectTerm term = fogcomp::model::expression_term("x = " + text);
  set_ranges(term);
  fogcomp::model::Model model = fog::test::paper_like_model();
  const double max = fogcomp::board::compile_expression(term, model, 1).max;
  term.expression->scale_log2 = max > 0 ? std::ilogb(max) - 1 : 0;
  return term;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}

  std::string expression(int depth) {
    const int kind = pick(depth > 0 ? 16 : 3);
    const auto sub = [&] { return expression(depth - 1); };
    switch (kind) {
      case 0:
        return number();
      case 1:
      case 2:
        return signal();
      case 3:
        return "(" + sub() + "+" + sub() + ")";
      case 4:
        return "(" + sub() + "-" + sub() + ")";
      case 5:
      case 6:
        return sub() + "*" + sub();
      case 7:
        return sub() + "/(3+abs(" + signal() + "))";
      case 8:
        return "(" + sub() + ")^" + std::to_string(1 + pick(4));
      case 9:
        return "-" + sub();
      case 10:
        return (pick(2) == 0 ? "sin(" : "cos(") + sub() + "/50)";
      case 11:
        return "exp(-abs(" + sub() + ")/20)";
      case 12:
        return "tanh(" + sub() + "/10)";
      case 13:
        return (pick(2) == 0 ? "min(" : "max(") + sub() + "," + sub() + ")";
      case 14:
        return "lag(" + signal() + "," + std::to_string(5 + pick(2000)) + ")";
      default:
        return "play(" + signal() + "," + std::to_string(1 + pick(15)) + ")";
    }
  }

 private:
  int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  std::string number() { return std::to_string(0.01 * (1 + pick(3000))); }
  std::string signal() {
    const char* const names[] = {"T", "dTdt", "T", "t", "W", "T2", "B", "P", "V", "g"};
    return names[pick(10)];
  }
  std::mt19937_64 random_;
};

TEST(Expressions, AreOnTheBoardWithinTheirBoundOfDouble) {
  for (const char* text :
       {"T*T*dTdt", "lag(T,300)-T", "play(T,6)-T", "exp(-t/1200)", "sin(T/3)*dTdt", "tanh(T/20)",
        "min(T,20)*V", "max(abs(dTdt)-1,0)", "W*(T-20)", "P/(1+P)", "(T2-T)*dTdt/V",
        "lag(dTdt,20000)", "((T-20)/64)^9", "1/(273.15+T)", "exp(T/25)", "-B^3", "lag(t,60)",
        "g^2"}) {
    const Outcome outcome = run(term_of(text), 3, 20000);
    std::printf("  %-22s within %.1e, bound %.1e\n", text, outcome.worst, outcome.bound);
    EXPECT_LE(outcome.worst, outcome.bound) << text;
    EXPECT_LE(outcome.bound, 1e-3) << text;  // a bound that says something
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(Expressions, OfAnyFormAreWithinTheirBoundOrRefused) {
  int compared = 0;
  int useful = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const std::string text = "T*0.001+" + Random(seed).expression(4);
    EffectTerm term;
    try {
      term = term_of(text);
    } catch (const fogcomp::InputError&) {
      continue;  // too large for 32 bits, a divisor of 0 ...
    }
    const Outcome outcome = run(term, seed, 2000);
    EXPECT_LE(outcome.worst, outcome.bound) << text;
    ++compared;
    useful += outcome.bound < 1e-3 ? 1 : 0;
  }
  std::printf("  %d of 400 compared, %d with a bound below 1e-3\n", compared, useful);
  EXPECT_GT(compared, 200);
  EXPECT_GT(useful, 100);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
