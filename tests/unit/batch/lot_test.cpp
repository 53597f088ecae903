#include "batch/lot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace fogcomp::batch {
namespace {

constexpr std::size_t kFigures = 15;

std::vector<std::string> names() {
  std::vector<std::string> names{"noise_dprh", "fit_rms_dph"};
  while (names.size() < kFigures) names.push_back("effect.c" + std::to_string(names.size()));
  return names;
}

// Simulated scatter of production: noise by ratios, coefficients by differences.
std::vector<GyroResult> clean_lot(std::size_t gyros, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<GyroResult> results;
  for (std::size_t i = 0; i < gyros; ++i) {
    results.push_back({"G" + std::to_string(i + 1), "", "", {}});
    for (const std::string& name : names()) {
      const bool is_size = name.find('.') == std::string::npos;
      const double value = normal(random);
      results.back().figures.emplace_back(name, is_size ? 0.001 * std::exp(0.1 * value) : value);
    }
  }
  return results;
}

TEST(Lot, NamesAGyroOfACleanLotNoMoreOftenThanItSays) {
  for (const std::size_t gyros : {kMinLot, std::size_t{12}, std::size_t{30}, std::size_t{100}}) {
    std::mt19937_64 random(gyros);
    constexpr int kLots = 300;
    int named = 0;
    for (int lot = 0; lot < kLots; ++lot) {
      named += compare_lot(clean_lot(gyros, random), names()).outliers.empty() ? 0 : 1;
    }
    EXPECT_LE(named, 9) << gyros;  // 3 of 300: more than 9 in 1 of 1000 cases
  }
}

TEST(Lot, NamesAnOutlierByTheFigureThatMakesItOne) {
  std::mt19937_64 random(1);
  std::vector<GyroResult> results = clean_lot(30, random);
  results[6].figures[0].second *= 4;  // 14 spreads
  results[11].figures[4].second = -25;
  const Lot lot = compare_lot(results, names());
  ASSERT_EQ(lot.outliers.size(), 2U);
  EXPECT_EQ(lot.outliers[0].gyro, "G12");
  EXPECT_EQ(lot.outliers[0].figure, "effect.c4");
  EXPECT_LT(lot.outliers[0].score, -lot.bound);
  EXPECT_EQ(lot.outliers[1].gyro, "G7");
  EXPECT_EQ(lot.outliers[1].figure, "noise_dprh");
  const std::string words = outlier_words(lot, lot.outliers[1]);
  EXPECT_NE(words.find("noise_dprh 0.00"), std::string::npos) << words;
  EXPECT_NE(words.find("spreads above)"), std::string::npos) << words;
}

TEST(Lot, OfFewGyrosComparesNothing) {
  std::mt19937_64 random(1);
  std::vector<GyroResult> results = clean_lot(kMinLot - 1, random);
  results[0].figures[0].second = 1e9;
  EXPECT_TRUE(compare_lot(results, names()).figures.empty());
}

TEST(Lot, AsksNoFigureThatIsTheSameForMost) {
  std::mt19937_64 random(1);
  std::vector<GyroResult> results = clean_lot(20, random);
  for (std::size_t i = 1; i < results.size(); ++i) results[i].figures[3].second = 2;
  const Lot lot = compare_lot(results, names());
  EXPECT_EQ(lot.figures.size(), kFigures - 1);
  EXPECT_TRUE(lot.outliers.empty());
}

}  // namespace
}  // namespace fogcomp::batch
