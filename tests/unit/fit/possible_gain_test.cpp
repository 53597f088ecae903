#include "fit/possible_gain.hpp"

#include <gtest/gtest.h>

#include "fit/decision_rules.hpp"
#include "model/effect_list.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kSigma_dph = 0.02;

// A gyro with a ripple, and models of it that lack a part of its formula.
class PossibleGain : public testing::Test {
 protected:
  explicit PossibleGain(const std::string& ripple = "") {
    model::Model gyro = fog::test::model_of(model::parse_effects("bias," + ripple));
    gyro.terms[0].coefficients_dph = {0.5};
    gyro.terms[1].coefficients_dph = {0.06, 0.04};
    series_.add(series::make_blocks(fog::test::recording_of(gyro, {kSigma_dph, 0, 300}, 1)));
    noise_.white_variance = kSigma_dph * kSigma_dph;
  }
  double gain(const std::string& before, const std::string& after) const {
    return possible_gain(series_, model::parse_effects("bias," + before),
                         model::parse_effects("bias," + after),
                         {noise_, series_.rows().weights, false});
  }
  // Chi^2 of the best coefficients.
  double chi2(const std::string& effects) const {
    std::vector<Eigen::MatrixXd> columns;
    for (const model::EffectTerm& term : model::parse_effects("bias," + effects)) {
      columns.push_back(series_.regressors(term));
    }
    const series::Rows& rows = series_.rows();
    return solve_linear(side_by_side(columns, rows.size()), rows.drift_dph).residual.squaredNorm() /
           noise_.white_variance;
  }

 private:
  model::Model any_ = fog::test::truth();
  series::SignalSeries series_{any_};
  noise::NoiseModel noise_;
};

class PossibleGainOfChirp : public PossibleGain {
 protected:
  PossibleGainOfChirp() : PossibleGain("polarization_ripple:period=9,chirp=0.01") {}
};
TEST_F(PossibleGainOfChirp, IsAboutWhatItBrings) {
  const double fall =
      chi2("polarization_ripple:period=9") - chi2("polarization_ripple:period=9,chirp=0.01");
  ASSERT_GT(fall, 100);
  EXPECT_NEAR(gain("polarization_ripple:period=9", "polarization_ripple:period=9,chirp=?"), fall,
              0.2 * fall);
}
TEST_F(PossibleGainOfChirp, IsNoneWhereItIsThere) {
  EXPECT_LT(gain("polarization_ripple:period=9,chirp=0.01", "polarization_ripple:period=9,chirp=?"),
            rules::kVisible * rules::kVisible);
  EXPECT_EQ(gain("polarization_ripple:period=9", "polarization_ripple:period=9"), 0);
}

// Nothing is known of the place of a part that is left out.
class PossibleGainOfSecondPart : public PossibleGain {
 protected:
  PossibleGainOfSecondPart() : PossibleGain("polarization_ripple:period=23") {}
};
TEST_F(PossibleGainOfSecondPart, IsLookedForEverywhere) {
  const double fall =
      chi2("polarization_ripple:period=5") - chi2("polarization_ripple:period=5,period2=23");
  ASSERT_GT(fall, 1000);
  EXPECT_NEAR(gain("polarization_ripple:period=5", "polarization_ripple:period=5,period2=?"), fall,
              0.1 * fall);
}

}  // namespace
}  // namespace fogcomp::fit
