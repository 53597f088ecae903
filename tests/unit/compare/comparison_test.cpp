#include "compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/residual_analysis.hpp"
#include "support/evidence.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::compare {
namespace {

Comparison compare(const model::Model& model, const recording::Recording& recording) {
  return compare_with(model, runs::run_of(recording, {10}), 10);
}

TEST(Comparison, AConstantIsJudgedAsTheModelIs) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (double& rate : recording.rate_dph) rate += 3;  // a turn-on bias counts against both
  const Comparison comparison = compare(fog::test::truth(), recording);
  const double constant = comparison.modelled_dph.mean();
  const std::vector<double> measured = comparison.measured_dph();
  const auto left_by_constant = [&](recording::RowRange range) {
    double square = 0;
    for (std::size_t i = range.first; i < range.end; ++i) {
      square += std::pow(measured[i] - constant, 2);
    }
    return std::sqrt(square / static_cast<double>(range.size()));
  };
  for (const Comparison::SegmentError& segment : comparison.segments) {
    EXPECT_NEAR(constant_rms_dph(comparison, segment), left_by_constant(segment.rows), 1e-9);
  }
  EXPECT_NEAR(constant_rms_dph(comparison, comparison.whole),
              left_by_constant(comparison.whole.rows), 1e-9);
  EXPECT_LT(comparison.whole.rms_dph, constant_rms_dph(comparison, comparison.whole));
}

TEST(Comparison, KnowsTheInputsThatVary) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double input = 1000 * std::sin(0.01 * static_cast<double>(i));
    recording.input_rate_dph.push_back(input);
    recording[fog::Input::supply].push_back(0.1 + 0.2);  // stands still
    recording[fog::Input::light_power].push_back(
        30 + std::cos(0.1 * std::sqrt(2.0) * static_cast<double>(i)));
    recording.rate_dph[i] += input * 1.0003;  // 300 ppm that the model does not have
  }
  const Comparison comparison = compare(fog::test::truth(), recording);
  ASSERT_EQ(comparison.inputs.size(), 2U);
  EXPECT_EQ(comparison.inputs[0].input, fog::Input::light_power);
  EXPECT_EQ(comparison.inputs[1].input, fog::Input::input_rate);
  ASSERT_EQ(comparison.inputs[1].values.size(), comparison.size());

  const ResidualAnalysis analysis = analyse_residual(comparison);
  ASSERT_EQ(analysis.inputs.size(), 2U);
  EXPECT_LT(analysis.share_of_excess(analysis.inputs[0].test).value_or(0), 0.2);
  EXPECT_TRUE(analysis.inputs[1].test.structured());
  EXPECT_GT(analysis.share_of_excess(analysis.inputs[1].test).value_or(0), 0.9);
  for (const ResidualBin& bin : analysis.inputs[1].bins) {
    EXPECT_NEAR(bin.mean_dph, 3e-4 * bin.at, 5 * bin.sigma_dph);
  }
  EXPECT_GT(analysis.input_rate_share.value_or(0), 0.9);
}

// 10 ppm/degC: at no input rate does the mean residual differ from 0.
TEST(Comparison, KnowsWhatGoesWithTheInputRateAndTemperatureTogether) {
  const auto analysis_with = [](double per_degc) {
    recording::Recording recording =
        fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
    double mean_degc = 0;
    for (const double degc : recording.temperature_degc) {
      mean_degc += degc / static_cast<double>(recording.rows());
    }
    for (std::size_t i = 0; i < recording.rows(); ++i) {
      const double input = 1000 * std::sin(0.01 * static_cast<double>(i));
      recording.input_rate_dph.push_back(input);
      recording.rate_dph[i] += input * (1 + per_degc * (recording.temperature_degc[i] - mean_degc));
    }
    return analyse_residual(compare(fog::test::truth(), recording));
  };
  const ResidualAnalysis found = analysis_with(1e-5);
  EXPECT_LT(found.share_of_excess(found.inputs.at(0).test).value_or(0), 0.2);
  EXPECT_GT(found.input_rate_share.value_or(0), 0.9);
  EXPECT_LT(analysis_with(0).input_rate_share.value_or(1), kNoticeable);
  const auto at_rest = fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  EXPECT_FALSE(analyse_residual(compare(fog::test::truth(), at_rest)).input_rate_share);
}

}  // namespace
}  // namespace fogcomp::compare
