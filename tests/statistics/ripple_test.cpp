// How well the shapes of a ripple are found: a search over periods, of seconds under the
// sanitizers.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "model/shape_parameter.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::truth;
using model::Model;

// The ripple found in truth() with one of these shapes and sizes, by a fit with these effects.
model::EffectTerm fitted_ripple(const std::vector<double>& shape, const std::vector<double>& sizes,
                                const fog::test::RowNoise& noise, std::uint64_t seed,
                                const std::string& effects) {
  Model real = truth();
  real.terms.push_back(fog::test::natural_term("polarization_ripple", shape, sizes));
  const auto recording = fog::test::recording_of(real, noise, seed);
  Model model = fog::test::model_of(model::parse_effects(effects));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  identify(model, series);
  return model.terms.back();
}

// The first search with a single period settles on either.
TEST(IdentifiedRipple, HasASecondPeriodWhereAsked) {
  const model::EffectTerm term =
      fitted_ripple({9, 31}, {0.006, 0.004, 0.02, -0.02}, {0.024, 0.003, 300}, 2,
                    "bias,bias_temperature:order=3,temperature_rate,polarization_ripple:period2=?");
  ASSERT_EQ(term.coefficients_dph.size(), 4U);
  EXPECT_NEAR(term.parameters[0].value, 9, 4 * term.parameters[0].sigma);
  EXPECT_NEAR(term.parameters[1].value, 31, 4 * term.parameters[1].sigma);
  EXPECT_LT(term.parameters[1].sigma, 2);
}

TEST(IdentifiedRipple, HasAChirpWhereAsked) {
  const model::EffectTerm term =
      fitted_ripple({13, 0, 0.05}, {0.02, 0.01}, {0.024, 0.003, 300}, 3,
                    "bias,bias_temperature:order=3,temperature_rate,polarization_ripple:chirp=?");
  EXPECT_NEAR(term.parameters[0].value, 13, 4 * term.parameters[0].sigma);
  EXPECT_NEAR(term.parameters[2].value, 0.05, 4 * term.parameters[2].sigma);
  EXPECT_LT(term.parameters[2].sigma, 0.01);
  const std::vector<model::ShapeParameter> searched =
      model::shape_parameters(model::parse_effects("polarization_ripple"));
  ASSERT_EQ(searched.size(), 1U);
  EXPECT_EQ(searched[0].index, 0U);
}

// A strong ripple with a slightly wrong period leaves more than the weak one has, so that a
// neighbour of the strong one can be taken for it.
TEST(IdentifiedRipple, HasAWeakSecondPeriodBesideAStrongOneWhereverTheyAre) {
  constexpr double kStrongAndWeak[][2] = {{31, 19}, {46, 11}};
  for (const auto& [strong, weak] : kStrongAndWeak) {
    const model::EffectTerm term = fitted_ripple(
        {strong, weak}, {-0.008, 0.029, 0.003, 0.0035}, {0.024, 0.002, 300}, 1,
        "bias,bias_temperature:order=2,temperature_rate,warm_up,polarization_ripple:period2=?");
    EXPECT_NEAR(term.parameters[0].value, weak, 0.07 * weak) << strong;
    EXPECT_NEAR(term.parameters[1].value, strong, 0.04 * strong) << weak;
  }
}

}  // namespace
}  // namespace fogcomp::fit
