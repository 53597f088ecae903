#include "diagnosis/model_fit.hpp"

#include <gtest/gtest.h>

#include "diagnosis/decision_rules.hpp"
#include "support/input_error.hpp"
#include "unit/fit/made_rows.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

using noise::NoiseModel;

NoiseModel known_noise() {
  NoiseModel noise;
  noise.row_s = 10;
  noise.white_variance = 0.01;
  return noise;
}

// Excluded rows have no weight; the others are weighted by their duration.
TEST(ModelFit, RmsIsOverTheTimeOfTheRowsThatCount) {
  series::Rows rows = fog::test::made_rows(4, [](double) { return 20.0; });
  rows.weights << 1, 1, 0.5, 1;
  fit::NoiseWeightedFit fit;
  fit.row_weights = Eigen::Vector4d(7, 7, 7, 0);
  const Eigen::Vector4d residual(1, 2, 4, 1000);
  EXPECT_DOUBLE_EQ(rms_of_rows(rows, fit, residual), std::sqrt((1 + 4 + 0.5 * 16) / 2.5));
}

// The same run again with an offset of 0.5 deg/h: the bias belongs to the recording and does not
// change the residual.
TEST(ModelFit, EachRecordingHasABiasOfItsOwn) {
  const model::Model model = fog::test::truth();
  recording::Recording recording = fog::test::recording_of(model, {}, 1);
  std::vector<runs::Run> both{runs::run_of(recording, {10})};
  for (double& rate : recording.rate_dph) rate += 0.5;
  recording.file = "another";
  both.push_back(runs::run_of(recording, {10}));
  const DiagnosisData data(model, both);
  const fit::NoiseWeightedFit fit = fit_for_diagnosis(model, data, known_noise());
  ASSERT_EQ(fit.coefficients.size(), fit.linear());
  EXPECT_NEAR(fit.coefficients[fit.linear() - 1], 0.5, 1e-4);
  const Eigen::Index half = fit.residual_dph.size() / 2;
  EXPECT_LT((fit.residual_dph.head(half) - fit.residual_dph.tail(half)).norm(), 1e-6);
}

TEST(ModelFit, NoiseThatIsKnownIsTakenAsItIs) {
  const model::Model model = fog::test::truth();
  DiagnosisData data(model, {runs::run_of(fog::test::recording_of(model, fog::test::kQuietNoise, 1),
                                          {model.average_s})});
  const fit::NoiseWeightedFit fit = fit_for_diagnosis(model, data, known_noise());
  EXPECT_EQ(fit.noise.white_variance, 0.01);
  EXPECT_TRUE(fit.noise.components.empty());
  EXPECT_NEAR(fit_for_diagnosis(model, data, std::nullopt).noise.white_dph(), 0.024, 0.001);
}

TEST(ModelFit, TooFewRowsAreRefused) {
  const model::Model model = fog::test::truth();
  const recording::Recording recording = fog::test::recording_of(model, fog::test::kQuietNoise, 1);
  const auto fits = [&](std::ptrdiff_t rows) {
    recording::Recording part = recording;
    for (auto* column : {&part.time_s, &part.temperature_degc, &part.rate_dph}) {
      column->resize(static_cast<std::size_t>(rows));
    }
    DiagnosisData data(model, {runs::run_of(part, {model.average_s})});
    fit_for_diagnosis(model, data, known_noise());
  };
  EXPECT_NO_THROW(fits(rules::kMinRows));
  EXPECT_THROW(fits(rules::kMinRows - 1), InputError);
}

}  // namespace
}  // namespace fogcomp::diagnosis
