// A network that describes an effect missing in the model: what it had learnt.
#include "diagnosis/network_learnt.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/diagnosis.hpp"
#include "fit/fit_model.hpp"
#include "model/effect_list.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace {

using fog::test::model_of;
using fogcomp::diagnosis::NetworkLearnt;
using fogcomp::model::Model;

// `hidden` is in the gyro and not in the model; the network sees temperature and its rate.
NetworkLearnt learnt_of(const fogcomp::model::EffectTerm& hidden) {
  const fogcomp::recording::Recording recording = fog::test::recording_of(
      model_of({fog::test::natural_term("bias", {}, {0.7}),
                fog::test::natural_term("bias_temperature", {2}, {-4e-4, -3e-5}), hidden}),
      fog::test::kQuietNoise, 1);
  Model model = model_of(fogcomp::model::parse_effects("bias,bias_temperature:order=2"));
  fogcomp::series::SignalSeries series(model);
  series.add(fogcomp::series::make_blocks(recording));
  fogcomp::fit::FitSettings settings;
  settings.network.hidden = 6;
  fogcomp::fit::fit_model(model, series, settings);
  fogcomp::diagnosis::DiagnosisData data(model,
                                         {fogcomp::runs::run_of(recording, {model.average_s})});
  return fogcomp::diagnosis::diagnose(model, data).network.value();
}

double share_of(const NetworkLearnt& learnt, const std::string& effect) {
  const auto found =
      std::find_if(learnt.effects.begin(), learnt.effects.end(),
                   [&](const NetworkLearnt::Share& share) { return share.term.name == effect; });
  return found == learnt.effects.end() ? 0 : found->share;
}

TEST(NetworkLearnt, NamesTheEffectForWhichTheNetworkStandsIn) {
  const NetworkLearnt learnt = learnt_of(fog::test::natural_term("temperature_rate", {}, {0.12}));
  EXPECT_GT(learnt.rms_dph, 0.03);
  EXPECT_GT(share_of(learnt, "temperature_rate"), fogcomp::diagnosis::kLearntShare);
  EXPECT_LT(learnt.effects[0].share, share_of(learnt, "temperature_rate") + 0.1);
  EXPECT_LT(share_of(learnt, "polarization_ripple"), 0.3);
}

TEST(NetworkLearnt, NamesNoneWhereTheCatalogueHasNone) {
  fogcomp::model::EffectTerm hidden = fog::test::written_term("heat = abs(dTdt)");
  hidden.coefficients_dph = {1};  // the regressor is small, as its range is +-32 degC/min
  const NetworkLearnt learnt = learnt_of(hidden);
  EXPECT_GT(learnt.rms_dph, 0.01);
  EXPECT_LT(learnt.effects[0].share, fogcomp::diagnosis::kLearntShare);
}

}  // namespace
