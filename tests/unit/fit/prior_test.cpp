#include "fit/prior.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::kQuietNoise;
using fog::test::model_of;
using fog::test::recording_of;

// b + b1 (T - 20) and a lagged temperature rate.
model::Model gyro(double rate) {
  model::Model model = model_of(model::parse_effects("bias,bias_temperature:order=1,shupe"));
  model.terms[0].coefficients_dph = {0.5};
  model.terms[1].coefficients_dph = {0.01};
  model.terms[2].coefficients_dph = {rate};
  model.terms[2].parameters[0].value = 300;
  return model;
}

struct Fitted {
  model::Model model;
  Identification found;
};
Fitted fitted(const model::Model& truth, std::uint64_t seed, std::optional<Prior> prior) {
  Fitted result;
  result.model = model_of(model::parse_effects("bias,bias_temperature:order=1,shupe"));
  if (prior) result.model.terms = prior->terms;
  series::SignalSeries series(result.model);
  series.add(series::make_blocks(fog::test::thinned(recording_of(truth, kQuietNoise, seed), 3)));
  IdentifySettings settings;
  settings.prior = std::move(prior);
  result.found = identify(result.model, series, settings);
  return result;
}

double sigma(const model::Model& model, std::size_t term) {
  return model.terms[term].gyro->coefficients_dph[0].sigma;
}

class PriorFit : public testing::Test {
 protected:
  static constexpr double kRate = 1;
  const Fitted first_ = fitted(gyro(kRate), 1, {});
  const Prior prior_ = prior_of(first_.model, "first.model");
};

TEST_F(PriorFit, OfTheSameGyroKnowsItBetterThanEitherRun) {
  const Fitted second = fitted(gyro(kRate), 2, prior_);
  const Fitted alone = fitted(gyro(kRate), 2, {});
  for (std::size_t term = 1; term < 3; ++term) {
    const double both = 1 / std::hypot(1 / sigma(first_.model, term), 1 / sigma(alone.model, term));
    EXPECT_LT(sigma(second.model, term), 1.1 * both) << term;
  }
  // The simulated drift is a board's.
  const model::Estimate rate = second.model.terms[2].coefficients_dph[0];
  EXPECT_NEAR(rate.value, kRate, 3 * rate.sigma);
  for (const Departure& departure : second.found.departures) EXPECT_FALSE(departure.is_certain());
}

TEST_F(PriorFit, OfAGyroThatHasChangedSaysWhatMovedAndFollowsTheRun) {
  constexpr double kNow = 2;
  const Fitted second = fitted(gyro(kNow), 2, prior_);
  const std::vector<std::string> names = names_of_unknowns(prior_.terms);
  ASSERT_EQ(names.size(), second.found.departures.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(second.found.departures[i].is_certain(), names[i].rfind("shupe.K", 0) == 0)
        << names[i];
  }
  const Fitted alone = fitted(gyro(kNow), 2, {});
  EXPECT_NEAR(second.model.terms[2].gyro->coefficients_dph[0].value,
              alone.model.terms[2].gyro->coefficients_dph[0].value, sigma(alone.model, 2));
}

TEST_F(PriorFit, OfAModelWithoutUncertaintiesIsRefused) {
  model::Model old = first_.model;
  old.uncertainty.reset();
  EXPECT_THROW(prior_of(old, "old.model"), InputError);
}

// unknowns = origin + slopes * independent ones, of the prior's covariance and mean.
TEST_F(PriorFit, HasIndependentUnknownsOfItsCovariance) {
  const Eigen::Index shapes = prior_.gyro_mean.size() - prior_.coefficients();
  ASSERT_EQ(shapes, 1);
  const Independent at_mean =
      independent(prior_, series::Reading::of_gyro, prior_.gyro_mean.tail(shapes));
  EXPECT_TRUE(at_mean.origin.head(prior_.coefficients())
                  .isApprox(prior_.gyro_mean.head(prior_.coefficients()), 1e-12));
  EXPECT_TRUE((at_mean.slopes * at_mean.slopes.transpose()).isApprox(prior_.covariance, 1e-9));
}

}  // namespace
}  // namespace fogcomp::fit
