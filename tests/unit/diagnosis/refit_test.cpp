#include "diagnosis/model_fit.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

using model::EffectTerm;
using model::parse_effects;

std::vector<std::string> names_of(const std::vector<EffectTerm>& terms) {
  std::vector<std::string> names;
  for (const EffectTerm& term : terms) names.push_back(term.name);
  return names;
}

TEST(WithTerm, TakesTheLastPlaceAndThatOfASmallerVersion) {
  std::vector<EffectTerm> terms =
      model::parse_effects("bias,bias_temperature:order=2,temperature_rate");
  terms = with_term(std::move(terms), model::parse_effects("aging")[0]);
  terms = with_term(std::move(terms), model::parse_effects("bias_temperature:order=4")[0]);
  EXPECT_EQ(names_of(terms),
            (std::vector<std::string>{"bias", "temperature_rate", "aging", "bias_temperature"}));
  EXPECT_EQ(terms.back().parameters[0].value, 4);
}

// Two recordings of one gyro without noise, the second with a bias of its own.
TEST(Refit, FindsTheCoefficientsBesideABiasOfEachRecording) {
  const model::Model truth =
      fog::test::model_of({fog::test::natural_term("bias", {}, {0.7}),
                           fog::test::natural_term("temperature_rate", {}, {0.12}),
                           fog::test::natural_term("thermal_lag", {600}, {0.08})});
  series::SignalSeries series(truth);
  for (const double offset_dph : {0.0, 0.3}) {
    recording::Recording recording = fog::test::recording_of(truth, {}, 1);
    for (double& rate : recording.rate_dph) rate += offset_dph;
    series.add(series::make_blocks(recording));
  }
  const auto fit =
      fit::fit_rows(series, model::parse_effects("bias"), fit::run_offset_columns(series.rows()));
  const Refit result =
      refit(model::parse_effects("bias,temperature_rate,thermal_lag:tau=600"), series, fit);
  ASSERT_EQ(result.terms.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(result.terms[i].coefficients_dph.at(0).value,
                truth.terms[i].coefficients_dph[0].value, 1e-6)
        << result.terms[i].name;
  }
  EXPECT_EQ(result.terms[2].parameters[0].value, 600);
  EXPECT_LT(result.residual_dph.cwiseAbs().maxCoeff(), 1e-6);
  // The contribution of a missing effect remains.
  EXPECT_GT(refit(model::parse_effects("bias,temperature_rate"), series, fit).residual_dph.norm(),
            1);
}

}  // namespace
}  // namespace fogcomp::diagnosis
