#include "recording/csv_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <random>
#include <string>

#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::optional<double> scanned(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  if (scan_decimal(text.data(), end, value) != end) return std::nullopt;
  return value;
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(ScanDecimal, RoundsAsTheCLibraryDoes) {
  std::mt19937_64 random(1);
  const char* const patterns[] = {"%.3f", "%.6f", "%.12f", "%.17g", "%.5e", "%.25g", "%.0f"};
  for (int i = 0; i < 200000; ++i) {
    const double size = std::pow(10, static_cast<double>(random() % 24) - 8);
    const double value = (static_cast<double>(random()) / 9.2e18 - 1) * size;
    const std::string text = format(patterns[random() % 7], value);
    const auto got = scanned(text);
    ASSERT_TRUE(got.has_value()) << text;
    ASSERT_TRUE(same_bits(*got, std::strtod(text.c_str(), nullptr))) << text;
  }
}

TEST(ScanDecimal, TakesEveryUsualSpelling) {
  EXPECT_EQ(scanned("+3"), 3.0);
  EXPECT_EQ(scanned(".5"), 0.5);
  EXPECT_EQ(scanned("-5."), -5.0);
  EXPECT_EQ(scanned("1E+3"), 1000.0);
  EXPECT_EQ(scanned("000000000000000000000000000000.25"), 0.25);
  EXPECT_TRUE(same_bits(scanned("-0").value(), -0.0));
}

TEST(ScanDecimal, TakesNothingElse) {
  for (const char* text : {"", "-", "+-1", "--1", ".", "e5", "inf", "-inf", "nan", "NaN", "0x10",
                           "1e999", "1,5", "1 ", "abc", "1e"}) {
    EXPECT_EQ(scanned(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace fogcomp::recording
