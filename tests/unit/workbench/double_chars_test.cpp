// Decimals of the page's engine are those of the host's library, digit by digit: or a model file of
// the page would not be the shell's.

#include "workbench/engine/double_chars.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

namespace fogcomp::workbench {
namespace {

std::string by_library(double value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string by_engine(double value) {
  char text[64];
  return {text, print_shortest(text, value)};
}

void expect_same_reading(std::string_view text) {
  double expected = -1;
  double value = -1;
  const auto library = std::from_chars(text.data(), text.data() + text.size(), expected);
  const auto engine = scan(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(engine.ptr - text.data(), library.ptr - text.data()) << text;
  EXPECT_EQ(engine.ec, library.ec) << text;
  EXPECT_EQ(value, expected) << text;
}

void expect_same(double value) {
  const std::string text = by_library(value);
  EXPECT_EQ(by_engine(value), text) << value;
  if (std::isfinite(value)) expect_same_reading(text);
}

TEST(DoubleChars, OfAnyBitsAreTheLibrarys) {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 30'000; ++i) {
    const std::uint64_t bits = generator();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    expect_same(value);
  }
}

TEST(DoubleChars, OfFiguresAsTheyAreComputedAndRoundedAreTheLibrarys) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> figure(-100, 100);
  for (int i = 0; i < 20'000; ++i) {
    const double value = figure(generator);
    for (const double each : {value, std::round(value * 1e4) / 1e4, std::round(value * 1e20),
                              value * 1e-6, std::round(value)}) {
      expect_same(each);
    }
  }
}

// Below a power of two neighbours lie twice as near.
TEST(DoubleChars, OfPowersOfTwoAndTheirNeighboursAreTheLibrarys) {
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1, exponent);
    for (const double value :
         {power, -power, std::nextafter(power, 0), std::nextafter(power, 2 * power)})
      expect_same(value);
  }
}

TEST(DoubleChars, AreReadAsFarAsTheLibraryReadsThem) {
  for (const char* text :
       {"1e", "1e+", "-",     "-.",   ".5",       "5.",     "0x10", "1e400", "-1e400", "1e-400",
        " 1", "+1",  "1.2.3", "1e5x", "4.9e-324", "1e-320", "",     "007",   "1,5",    "12 13"}) {
    expect_same_reading(text);
  }
}

TEST(DoubleChars, WithDecimalsAreTheLibrarys) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> figure(-1e6, 1e6);
  for (int i = 0; i < 5'000; ++i) {
    const double value = figure(generator);
    char expected[64];
    char text[64];
    const std::string library(
        expected, std::to_chars(expected, expected + 64, value, std::chars_format::fixed, 6).ptr);
    EXPECT_EQ(std::string(text, print_fixed(text, text + 64, value, 6)), library);
  }
}

}  // namespace
}  // namespace fogcomp::workbench
