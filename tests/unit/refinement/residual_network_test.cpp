// A network on what effects leave learns what is there, not the slow noise.
#include "refinement/residual_network.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identification/effect_list.hpp"
#include "refinement/fit_model.hpp"
#include "support/typical_effects.hpp"
#include "unit/identification/simulated_gyro.hpp"

namespace {

using fogcomp::FitResult;
using fogcomp::Model;
using fogcomp::SignalSeries;

// Slow noise that wanders over half an hour is what a network is most ready to take for drift.
constexpr fog::test::RowNoise kSlowNoise{0.024, 0.006, 2000};

struct Fitted {
  Model model;
  FitResult result;
  Eigen::VectorXd left_dph;     // by the effects, of the drift without noise; per row
  Eigen::VectorXd network_dph;  // per row; 0 without one
};

// `gyro` fitted with the effects of truth() and 6 neurons.
Fitted fit(const Model& gyro, const fog::test::RowNoise& noise, std::uint64_t seed, bool force) {
  Fitted fitted;
  Model& model = fitted.model;
  model =
      fog::test::model_of(fogcomp::parse_effects("bias,bias_temperature:order=3,temperature_rate"));
  SignalSeries series(model);
  series.add(fogcomp::make_blocks(fog::test::recording_of(gyro, noise, seed)));
  fogcomp::FitSettings settings;
  settings.network.hidden = 6;
  settings.force_network = force;
  fitted.result = fit_model(model, series, settings);

  SignalSeries noise_free(model);
  noise_free.add(fogcomp::make_blocks(fog::test::recording_of(gyro, {}, seed)));
  fitted.left_dph = noise_free.rows().drift_dph - series.drift_dph(model.terms);
  fitted.network_dph.setZero(series.rows().size());
  if (!model.network.present()) return fitted;
  const Eigen::MatrixXd inputs = series.network_inputs(model.network.inputs);
  for (Eigen::Index row = 0; row < inputs.rows(); ++row) {
    fitted.network_dph[row] = model.network.drift_dph(inputs.row(row));
  }
  return fitted;
}

double mean_square(const Eigen::VectorXd& values) {
  return values.squaredNorm() / static_cast<double>(values.size());
}

TEST(ResidualNetwork, LearnsNextToNothingFromSlowNoise) {
  constexpr int kGyros = 10;
  double square = 0;
  for (std::uint64_t seed = 1; seed <= kGyros; ++seed) {
    square += mean_square(fit(fog::test::truth(), kSlowNoise, seed, true).network_dph);
  }
  EXPECT_LT(std::sqrt(square / kGyros), 0.0024) << "deg/h rms, forced to stay";
}

TEST(ResidualNetwork, IsNotKeptWhereThereIsNothingToLearn) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Fitted fitted = fit(fog::test::truth(), kSlowNoise, seed, false);
    EXPECT_FALSE(fitted.model.network.present()) << "gain " << fitted.result.network_judged->gain;
    EXPECT_EQ(fitted.model.residual_rms_dph, fitted.result.effects_rms_dph);
  }
}

TEST(ResidualNetwork, LearnsAnEffectThatIsLeftOut) {
  Model gyro = fog::test::truth();
  gyro.terms.push_back(fog::test::natural_term("polarization_ripple", {40, 0}, {0.03, 0.03}));
  const Fitted fitted = fit(gyro, fog::test::kQuietNoise, 1, false);
  ASSERT_TRUE(fitted.model.network.present());
  EXPECT_GT(fitted.result.network_judged->gain, 5 * fogcomp::kLeastGain);
  EXPECT_LT(mean_square(fitted.left_dph - fitted.network_dph), 0.1 * mean_square(fitted.left_dph));
  EXPECT_EQ(fit(gyro, fog::test::kQuietNoise, 1, true).network_dph, fitted.network_dph)
      << "not the same again";
}

}  // namespace
