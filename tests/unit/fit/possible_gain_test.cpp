#include "fit/shape_search.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kSigma_dph = 0.02;

// A gyro with a ripple, and models of it that lack a part of its formula.
class GyroWithRipple {
 public:
  explicit GyroWithRipple(const std::string& ripple) {
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

// Of a second part, whose place nothing tells, and of a chirp.
TEST(PossibleGain, IsAboutWhatTheFreedShapeBrings) {
  const std::string ripple = "polarization_ripple:";
  const struct {
    const char *gyro, *before, *complete, *freed;
    double min_fall, tolerance;
  } kCases[] = {
      {"period=9,chirp=0.01", "period=9", "period=9,chirp=0.01", "period=9,chirp=?", 100, 0.2},
      {"period=23", "period=5", "period=5,period2=23", "period=5,period2=?", 1000, 0.1},
  };
  for (const auto& one : kCases) {
    const GyroWithRipple gyro(ripple + one.gyro);
    const double fall = gyro.chi2(ripple + one.before) - gyro.chi2(ripple + one.complete);
    ASSERT_GT(fall, one.min_fall) << one.freed;
    EXPECT_NEAR(gyro.gain(ripple + one.before, ripple + one.freed), fall, one.tolerance * fall)
        << one.freed;
  }
}

TEST(PossibleGain, IsNoneWhereItIsThere) {
  const GyroWithRipple gyro("polarization_ripple:period=9,chirp=0.01");
  EXPECT_LT(
      gyro.gain("polarization_ripple:period=9,chirp=0.01", "polarization_ripple:period=9,chirp=?"),
      kCertainSigmas * kCertainSigmas);
  EXPECT_EQ(gyro.gain("polarization_ripple:period=9", "polarization_ripple:period=9"), 0);
}

}  // namespace
}  // namespace fogcomp::fit
