#include "fit/known_regressors.hpp"

#include <gtest/gtest.h>

#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

class KnownRegressorsOfARun : public testing::Test {
 protected:
  KnownRegressorsOfARun() {
    series_.add(series::make_blocks(fog::test::recording_of(gyro_, {0.002, 0, 300}, 1)));
  }
  const model::Model gyro_ = fog::test::truth();
  series::SignalSeries series_{gyro_};
  const KnownRegressors known_{series_};
};

TEST_F(KnownRegressorsOfARun, AreThoseOfTheSeriesHoweverMany) {
  model::EffectTerm lag = model::parse_effects("thermal_lag:tau=900")[0];
  constexpr Eigen::Index kMoreThanAreKept = 4'000'000;
  Eigen::Index values = 0;
  for (double tau_s = 900; values < kMoreThanAreKept; tau_s += 1) {
    lag.parameters[0].value = tau_s;
    values += known_(lag)->size();
  }
  for (const double tau_s : {900.0, 901.0, 900.0}) {
    lag.parameters[0].value = tau_s;
    for (const auto reading : {series::Reading::of_sensor, series::Reading::without_noise}) {
      EXPECT_EQ(*known_(lag, reading), series_.regressors(lag, reading)) << tau_s;
    }
  }
}

TEST_F(KnownRegressorsOfARun, OfAnotherReading_HaveTheirOwnColumns) {
  const model::EffectTerm lag = model::parse_effects("thermal_lag:tau=900")[0];
  const KnownRegressors of_gyro = known_.of(series::Reading::of_gyro);
  for (int time = 0; time < 2; ++time) {
    EXPECT_EQ(*known_(lag), series_.regressors(lag));
    EXPECT_EQ(*of_gyro(lag), series_.regressors(lag, series::Reading::of_gyro));
    for (const double degc : {0.0, 1.0}) {
      const series::TemperatureChange change{degc, 0.5};
      EXPECT_EQ(*known_(lag, series::Reading::of_gyro, change),
                series_.regressors(lag, series::Reading::of_gyro, change));
    }
  }
}

// Each part is remembered by itself.
TEST_F(KnownRegressorsOfARun, OfAnEffectWithTwoPartsAreItsOwn) {
  for (const char* const effect :
       {"polarization_ripple:period=9,period2=31,chirp=0.05",
        "thermal_hysteresis:radius=3,radius2=12", "polarization_ripple:period=9"}) {
    const model::EffectTerm term = model::parse_effects(effect)[0];
    for (const auto reading : {series::Reading::of_sensor, series::Reading::without_noise}) {
      EXPECT_EQ(*known_(term, reading), series_.regressors(term, reading)) << effect;
    }
  }
}

TEST_F(KnownRegressorsOfARun, OfTwoExpressionsWithOneNameDiffer) {
  for (const char* const definition : {"x = T^2", "x = abs(dTdt)"}) {
    model::EffectTerm term = model::expression_term(definition);
    for (const int scale_log2 : {0, 3}) {
      term.expression->scale_log2 = scale_log2;
      EXPECT_EQ(*known_(term), series_.regressors(term)) << definition << scale_log2;
    }
  }
}

}  // namespace
}  // namespace fogcomp::fit
