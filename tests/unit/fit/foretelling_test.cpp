#include "fit/foretelling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/left_out_parts.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace fogcomp::fit {
namespace {

// One simulated run, and the fit of effects to it.
struct FittedRun {
  explicit FittedRun(const std::string& effects)
      : model(fog::test::incomplete(effects)),
        known(model, fog::test::runs_of(fog::test::truth(), {1}).training),
        fit(fit_rows(known, model.terms, Eigen::MatrixXd(known.series().rows().size(), 0))),
        foretelling(known, {fit.terms, known.series().rows()},
                    {fit.noise, fit.row_weights, false}) {}

  const series::Rows& rows() const { return known.series().rows(); }

  model::Model model;
  KnownRegressors known;
  NoiseWeightedFit fit;
  Foretelling foretelling;
};

// Of rows that were left out, 68 % lie within a standard deviation and 95 % within two.
TEST(Foretelling, CompleteModel_ErrorsAreAsLargeAsForetold) {
  const FittedRun run(fog::test::kComplete);
  const std::vector<FarPart> far = far_parts(run.rows(), {});
  const Folds thirds{{far[0].part, far[1].part, far[2].part}, "on thirds", true};
  for (const Folds& folds : {stretches_in_turn(run.rows()), thirds}) {
    double rows = 0;
    double within_one = 0;
    double within_two = 0;
    for (const Part& part : folds.parts) {
      const judge::Foretold told = run.foretelling.of(part).rows;
      for (Eigen::Index i = 0; i < run.rows().size(); ++i) {
        if (told.variance[i] <= 0) continue;
        const double error =
            std::abs(run.rows().drift_dph[i] - told.mean_dph[i]) / std::sqrt(told.variance[i]);
        ++rows;
        within_one += error < 1 ? 1 : 0;
        within_two += error < 2 ? 1 : 0;
      }
    }
    EXPECT_GT(rows, 0.95 * static_cast<double>(run.rows().size())) << folds.how;
    EXPECT_NEAR(within_one / rows, 0.683, 0.03) << folds.how;
    EXPECT_NEAR(within_two / rows, 0.954, 0.02) << folds.how;
  }
}

TEST(Foretelling, RowsOutsideThePart_AreNotForetold) {
  const FittedRun run("bias");
  const Foretelling::OfPart told = run.foretelling.of({{100, 200}});
  EXPECT_EQ((told.rows.variance.array() > 0).count(), 100);
  EXPECT_GT(told.rows.variance[100], 0);
  EXPECT_EQ(told.rows.variance[200], 0);
  EXPECT_EQ(told.residual_dph.head(100).norm(), 0);
}

// A warm-up is over when the other rows begin: they tell next to nothing of its size.
TEST(Foretelling, EffectThatTheOtherRowsDoNotShow_IsUncertain) {
  const FittedRun with("bias,warm_up:tau=600");
  const FittedRun without("bias");
  const Part first = far_parts(with.rows(), {})[0].part;
  EXPECT_GT(with.foretelling.of(first).rows.variance.maxCoeff(),
            10 * without.foretelling.of(first).rows.variance.maxCoeff());
}

TEST(Foretelling, ShapeThatWasSought_CostsWhatItCouldBeChosenFrom) {
  const FittedRun given("bias,polarization_ripple:period=13");
  const FittedRun sought("bias,polarization_ripple");
  EXPECT_EQ(given.foretelling.log_choices(), 0);
  EXPECT_GT(sought.foretelling.log_choices(), 1);
}

}  // namespace
}  // namespace fogcomp::fit
