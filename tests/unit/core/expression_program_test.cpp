// spec/effects.md, "Expressions": valid programs, and the result of each operation.
#include "core/expression/expression_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/expression/expression_bank.hpp"

namespace {

using fog::ExpressionOp;
using Program = std::vector<std::int32_t>;

std::int32_t word(ExpressionOp op, std::int32_t argument = 0) {
  return static_cast<std::int32_t>(op) + 256 * argument;
}

Program joined(const std::vector<Program>& parts) {
  Program all;
  for (const Program& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}
Program repeated(std::size_t times, const Program& part) {
  return joined(std::vector<Program>(times, part));
}

const Program kConstant{word(ExpressionOp::constant), 1};
const Program kOutput{word(ExpressionOp::output)};

bool fits(const Program& program, std::size_t outputs = 1) {
  const Program coefficients(outputs);
  fog::ExpressionParameters parameters{
      {program.data(), program.size()}, {coefficients.data(), coefficients.size()}, 0};
  return fog::expressions_fit(parameters);
}

// ---- valid programs ----

// For an operation with so many operands and these following words.
bool fits_alone(ExpressionOp op, std::int32_t argument, std::size_t takes, std::size_t leaves,
                const Program& words = {}) {
  return fits(
      joined({repeated(takes, kConstant), {word(op, argument)}, words, repeated(leaves, kOutput)}),
      leaves);
}

TEST(ExpressionProgram, ArgumentsAreAcceptedUpToTheirLimits) {
  constexpr auto kLast = static_cast<std::int32_t>(fog::kInputs) - 1;
  const struct {
    ExpressionOp op;
    std::int32_t min, max;
    std::size_t takes, leaves;
    Program words;
  } operations[] = {
      {ExpressionOp::signal, 0, kLast, 0, 1, {-1, 1}},
      {ExpressionOp::constant, 0, 0, 0, 1, {0}},
      {ExpressionOp::duplicate, 0, 0, 1, 2, {}},
      {ExpressionOp::over, 0, 0, 2, 3, {}},
      {ExpressionOp::nip, 0, 0, 2, 1, {}},
      {ExpressionOp::shift, -31, 62, 1, 1, {}},
      {ExpressionOp::add, 0, 0, 2, 1, {}},
      {ExpressionOp::subtract, 0, 0, 2, 1, {}},
      {ExpressionOp::multiply, 0, 62, 2, 1, {}},
      {ExpressionOp::divide, 0, 30, 2, 1, {}},
      {ExpressionOp::negate, 0, 0, 1, 1, {}},
      {ExpressionOp::absolute, 0, 0, 1, 1, {}},
      {ExpressionOp::min, 0, 0, 2, 1, {}},
      {ExpressionOp::max, 0, 0, 2, 1, {}},
      {ExpressionOp::sine, 0, 62, 1, 1, {}},
      {ExpressionOp::cosine, 0, 62, 1, 1, {}},
      {ExpressionOp::decay, 0, 0, 1, 1, {}},
      {ExpressionOp::tanh, 0, 0, 1, 1, {}},
      {ExpressionOp::lag, 0, 0, 1, 1, {1}},
      {ExpressionOp::play, 0, 0, 1, 1, {1}},
  };
  for (const auto& [op, min, max, takes, leaves, words] : operations) {
    const int number = static_cast<int>(op);
    EXPECT_TRUE(fits_alone(op, min, takes, leaves, words)) << number;
    EXPECT_TRUE(fits_alone(op, max, takes, leaves, words)) << number;
    EXPECT_FALSE(fits_alone(op, min - 1, takes, leaves, words)) << number;
    EXPECT_FALSE(fits_alone(op, max + 1, takes, leaves, words)) << number;
    if (takes > 0) {  // a stack that runs empty
      EXPECT_FALSE(fits(joined({repeated(takes - 1, kConstant), {word(op, min)}, words})));
    }
  }
  for (const std::int32_t bits : {-31, 62}) {
    EXPECT_TRUE(fits(joined({kConstant, {word(ExpressionOp::output, bits)}})));
  }
  for (const std::int32_t bits : {-32, 63}) {
    EXPECT_FALSE(fits(joined({kConstant, {word(ExpressionOp::output, bits)}})));
  }
  EXPECT_FALSE(fits({word(ExpressionOp::output)}));
  EXPECT_FALSE(fits(joined({kConstant, {21}, kOutput})));
  EXPECT_FALSE(fits(joined({kConstant, {255}, kOutput})));
}

TEST(ExpressionProgram, WordsBehindAnOperationAreCheckedAndMustBeThere) {
  EXPECT_TRUE(fits_alone(ExpressionOp::signal, 0, 0, 1, {5, 5}));
  EXPECT_FALSE(fits_alone(ExpressionOp::signal, 0, 0, 1, {6, 5}));
  EXPECT_FALSE(fits_alone(ExpressionOp::lag, 0, 1, 1, {0}));
  EXPECT_TRUE(fits_alone(ExpressionOp::play, 0, 1, 1, {0}));
  EXPECT_TRUE(fits_alone(ExpressionOp::play, 0, 1, 1, {(1 << 30) - 1}));
  EXPECT_FALSE(fits_alone(ExpressionOp::play, 0, 1, 1, {-1}));
  EXPECT_FALSE(fits_alone(ExpressionOp::play, 0, 1, 1, {1 << 30}));
  for (const Program& cut :
       {Program{word(ExpressionOp::signal), 0}, {word(ExpressionOp::constant)}}) {
    EXPECT_FALSE(fits(cut, 0));
  }
  for (const ExpressionOp op : {ExpressionOp::lag, ExpressionOp::play}) {
    EXPECT_FALSE(fits(joined({kConstant, {word(op)}}), 0));
  }
}

TEST(ExpressionProgram, StackStatesAndOutputsAreCounted) {
  const Program nip{word(ExpressionOp::nip)};
  EXPECT_TRUE(fits(joined({repeated(16, kConstant), repeated(15, nip), kOutput})));
  EXPECT_FALSE(fits(joined({repeated(17, kConstant), repeated(16, nip), kOutput})));
  const Program lag{word(ExpressionOp::lag), 1}, play{word(ExpressionOp::play), 1};
  EXPECT_TRUE(fits(joined({kConstant, repeated(4, lag), repeated(4, play), kOutput})));
  EXPECT_FALSE(fits(joined({kConstant, repeated(5, lag), repeated(4, play), kOutput})));
  EXPECT_FALSE(fits(joined({kConstant, repeated(4, lag), repeated(5, play), kOutput})));
  const Program one = joined({kConstant, kOutput});
  EXPECT_TRUE(fits({}, 0));
  EXPECT_TRUE(fits(repeated(8, one), 8));
  EXPECT_FALSE(fits(repeated(9, one), 9));
  EXPECT_FALSE(fits(repeated(2, one), 1));
  EXPECT_FALSE(fits(one, 2));
  EXPECT_FALSE(fits(joined({kConstant, one}), 1)) << "a value is left on the stack";
}

TEST(ExpressionProgram, KnowsWhatItUses) {
  const Program program{word(ExpressionOp::signal, 5), 0, 1, word(ExpressionOp::output)};
  const std::int32_t coefficient = 1;
  fog::ExpressionParameters parameters{{program.data(), program.size()}, {&coefficient, 1}, 99};
  ASSERT_TRUE(fog::expressions_fit(parameters));
  EXPECT_EQ(parameters.used, fog::bit_of(ExpressionOp::signal) | fog::bit_of(ExpressionOp::output) |
                                 fog::expression_bit_of(fog::Input::magnetic));
}

TEST(ExpressionProgram, AnImageWithoutExpressionsHasNoneToRun) {
  const std::int32_t number = 1;
  fog::ExpressionParameters none;
  EXPECT_TRUE(fog::expressions_unknown(none));
  EXPECT_EQ(none.used, 0U);
  fog::ExpressionParameters some{{&number, 1}, {&number, 1}, 0};
  EXPECT_TRUE(fog::expressions_unknown(some));
  EXPECT_EQ(some.used, fog::kAllExpressions);  // more than any image has
  fog::ExpressionParameters no_program{{}, {&number, 1}, 0};
  EXPECT_FALSE(fog::expressions_unknown(no_program));
}

// ---- operations ----

using Signals = fog::Signals<fog::BoardNumbers>;

// The only regressor of a program, after a start with the first signals and a step with each of the
// others.
std::int32_t run(const Program& program, const std::vector<Signals>& history = {Signals{}}) {
  const std::int32_t coefficient = 1;
  fog::ExpressionParameters parameters{{program.data(), program.size()}, {&coefficient, 1}, 0};
  EXPECT_TRUE(fog::expressions_fit(parameters));
  fog::ExpressionBank<fog::kAllExpressions> bank(parameters, 10);
  bank.reset(history.front());
  for (const Signals& signals : history) bank.step(signals);
  return bank.regressors()[0].raw();
}

Program constant(std::int32_t value) {
  return {word(ExpressionOp::constant), value};
}
std::int32_t result(ExpressionOp op, const Program& operands, std::int32_t argument = 0) {
  Program program;
  for (const std::int32_t operand : operands) program = joined({program, constant(operand)});
  return run(joined({program, {word(op, argument)}, kOutput}));
}

TEST(ExpressionOperations, AddSubtractMultiplyRoundAndSaturate) {
  EXPECT_EQ(result(ExpressionOp::add, {7, -9}), -2);
  EXPECT_EQ(result(ExpressionOp::add, {INT32_MAX, 1}), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::add, {INT32_MIN, -1}), INT32_MIN);
  EXPECT_EQ(result(ExpressionOp::subtract, {7, 9}), -2);
  EXPECT_EQ(result(ExpressionOp::subtract, {INT32_MIN, 1}), INT32_MIN);
  EXPECT_EQ(result(ExpressionOp::multiply, {7, -9}), -63);
  EXPECT_EQ(result(ExpressionOp::multiply, {7, 9}, 1), 32);    // 31.5
  EXPECT_EQ(result(ExpressionOp::multiply, {7, -9}, 1), -31);  // -31.5
  EXPECT_EQ(result(ExpressionOp::multiply, {INT32_MIN, INT32_MIN}, 62), 1);
  EXPECT_EQ(result(ExpressionOp::multiply, {1 << 20, 1 << 20}), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::negate, {5}), -5);
  EXPECT_EQ(result(ExpressionOp::negate, {INT32_MIN}), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::absolute, {-5}), 5);
  EXPECT_EQ(result(ExpressionOp::absolute, {5}), 5);
  EXPECT_EQ(result(ExpressionOp::absolute, {INT32_MIN}), INT32_MAX);
}

TEST(ExpressionOperations, DivideRoundsBySignOfTheQuotientAndSurvivesZero) {
  EXPECT_EQ(result(ExpressionOp::divide, {7, 2}), 4);    // 3.5
  EXPECT_EQ(result(ExpressionOp::divide, {-7, 2}), -3);  // -3.5
  EXPECT_EQ(result(ExpressionOp::divide, {7, -2}), -3);
  EXPECT_EQ(result(ExpressionOp::divide, {-7, -2}), 4);
  EXPECT_EQ(result(ExpressionOp::divide, {1, 3}, 3), 3);  // 8 / 3
  EXPECT_EQ(result(ExpressionOp::divide, {1 << 20, 1}, 30), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::divide, {5, 0}), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::divide, {0, 0}), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::divide, {-5, 0}), -INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::divide, {5, 1}), 5);
  EXPECT_EQ(result(ExpressionOp::divide, {5, -1}), -5);
  EXPECT_EQ(result(ExpressionOp::divide, {1 << 30, INT32_MIN}, 2), -2);
  EXPECT_EQ(result(ExpressionOp::divide, {INT32_MIN, -INT32_MAX}, 30), (1 << 30) + 1);
}

TEST(ExpressionOperations, ShiftRoundsToTheRightAndSaturatesToTheLeft) {
  EXPECT_EQ(result(ExpressionOp::shift, {7}, 1), 4);
  EXPECT_EQ(result(ExpressionOp::shift, {-7}, 1), -3);
  EXPECT_EQ(result(ExpressionOp::shift, {-7}, 0), -7);
  EXPECT_EQ(result(ExpressionOp::shift, {INT32_MAX}, 62), 0);
  EXPECT_EQ(result(ExpressionOp::shift, {-3}, -4), -48);
  EXPECT_EQ(result(ExpressionOp::shift, {1}, -31), INT32_MAX);
  EXPECT_EQ(result(ExpressionOp::shift, {-1}, -31), INT32_MIN);
  EXPECT_EQ(run(joined({constant(7), {word(ExpressionOp::output, 1)}})), 4);
  EXPECT_EQ(run(joined({constant(7), {word(ExpressionOp::output, -1)}})), 14);
}

TEST(ExpressionOperations, LeastMostAndTheStack) {
  for (const Program& order : {Program{-3, 4}, Program{4, -3}}) {
    EXPECT_EQ(result(ExpressionOp::min, order), -3);
    EXPECT_EQ(result(ExpressionOp::max, order), 4);
  }
  const Program subtract{word(ExpressionOp::subtract)}, add{word(ExpressionOp::add)};
  const Program two = joined({constant(50), constant(3)});
  EXPECT_EQ(run(joined({constant(3), {word(ExpressionOp::duplicate)}, add, kOutput})), 6);
  // 50 3 50 -> 50 -47 -> 97
  EXPECT_EQ(run(joined({two, {word(ExpressionOp::over)}, subtract, subtract, kOutput})), 97);
  EXPECT_EQ(run(joined({constant(9), two, {word(ExpressionOp::nip)}, subtract, kOutput})), 6);
}

TEST(ExpressionOperations, FunctionsAreThoseOfTheirNames) {
  for (const std::int32_t raw : {-200000, -65536, 0, 30000, 102944, 411775}) {
    const double x = std::ldexp(raw, -16);
    EXPECT_NEAR(result(ExpressionOp::sine, {raw}, 16), std::ldexp(std::sin(x), 30), 10) << x;
    EXPECT_NEAR(result(ExpressionOp::cosine, {raw}, 16), std::ldexp(std::cos(x), 30), 10) << x;
  }
  for (const std::int32_t raw : {0, 1 << 24, 1 << 26, 1 << 29}) {
    EXPECT_NEAR(result(ExpressionOp::decay, {raw}), std::ldexp(std::exp(-std::ldexp(raw, -26)), 30),
                5);
    EXPECT_NEAR(result(ExpressionOp::tanh, {raw}), std::ldexp(std::tanh(std::ldexp(raw, -27)), 30),
                25);
  }
}

Signals signals_of(std::int32_t temperature) {
  Signals signals;
  signals.temperature = fog::Temperature::from_raw(temperature);
  return signals;
}

TEST(ExpressionOperations, SignalsAreWhatTheirNumbersSayWithinTheirLimits) {
  Signals signals = signals_of(100);
  signals.temperature_rate = fog::TemperatureRate::from_raw(101);
  signals.block.elapsed = fog::Elapsed::from_raw(102);
  signals.block.input_rate = fog::Rate::from_raw(103);
  std::int32_t value = 104;
  for (const fog::Input input :
       {fog::Input::temperature2, fog::Input::magnetic, fog::Input::light_power, fog::Input::supply,
        fog::Input::vibration}) {
    signals.block[input] = fog::ExtensionValue::from_raw(value++);
  }
  for (std::int32_t number = 0; number < 9; ++number) {
    const std::int32_t expected = 100 + number;
    const auto within = [&](std::int32_t min, std::int32_t max) {
      return run(joined({{word(ExpressionOp::signal, number), min, max}, kOutput}), {signals});
    };
    EXPECT_EQ(within(INT32_MIN, INT32_MAX), expected);
    EXPECT_EQ(within(expected + 5, INT32_MAX), expected + 5);
    EXPECT_EQ(within(INT32_MIN, expected - 5), expected - 5);
  }
}

TEST(ExpressionOperations, ALagStartsSettledAndMovesByItsDecay) {
  const Program program{word(ExpressionOp::signal),
                        INT32_MIN,
                        INT32_MAX,
                        word(ExpressionOp::lag),
                        1 << 29,  // a quarter
                        word(ExpressionOp::output)};
  EXPECT_EQ(run(program, {signals_of(1000)}), 1000);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(2000)}), 1250);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(2000), signals_of(2000)}), 1438);  // 1437.5
}

TEST(ExpressionOperations, APlayFollowsAtItsRadius) {
  const Program program{word(ExpressionOp::signal), INT32_MIN, INT32_MAX,
                        word(ExpressionOp::play),   100,       word(ExpressionOp::output)};
  EXPECT_EQ(run(program, {signals_of(1000)}), 1000);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(1100)}), 1000);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(1300)}), 1200);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(1300), signals_of(1150)}), 1200);
  EXPECT_EQ(run(program, {signals_of(1000), signals_of(1300), signals_of(500)}), 600);
  EXPECT_EQ(run(program, {signals_of(INT32_MAX)}), 1 << 30);
  EXPECT_EQ(run(program, {signals_of(INT32_MIN)}), -(1 << 30));
}

}  // namespace
