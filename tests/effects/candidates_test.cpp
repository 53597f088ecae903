#include "diagnosis/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "fit/noise_weighted_fit.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr fog::InputMask kTimeOnly = bit_of(fog::Input::elapsed);

// The rows of a gyro, and a model with only a constant.
class CandidatesTest : public testing::Test {
 protected:
  CandidatesTest() : series_(model_, series::Phase::zero) {
    series_.add(series::make_blocks(fog::test::thinned(fog::test::recording_of(model_, {}, 1), 6)));
    const series::Rows& rows = series_.rows();
    judge::Rows judged;
    judged.weights = rows.weights;
    judged.stretches = rows.stretches();
    modes_.emplace(std::move(judged));
  }

  static VisiblePart without_mean(const Eigen::MatrixXd& columns) {
    VisiblePart part{columns.rowwise() - columns.colwise().mean(), {}};
    part.visible = part.columns.colwise().norm().transpose();
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
      const double norm = columns.col(i).norm();
      part.visible[i] = norm > 0 ? part.visible[i] / norm : 0;
    }
    return part;
  }
  CandidateList found(const std::string& model, fog::InputMask inputs = kTimeOnly,
                      const std::vector<model::EffectTerm>& offered = {}) const {
    return find_candidates(space(), model::parse_effects(model), offered, inputs, [](double) {});
  }
  // The whitened column of one effect alone, of so many standard deviations.
  Eigen::VectorXd residual_of(const std::string& effect, double sigmas) const {
    const Eigen::MatrixXd columns = series_.regressors(model::parse_effects(effect)[0]);
    return sigmas * without_mean(columns.col(0)).columns.col(0).normalized();
  }

  model::Model model_ = fog::test::truth();
  series::SignalSeries series_;
  std::optional<judge::ModeSpace> modes_;
  ProjectOutModel project_out_model_ = without_mean;
  ShapeSpace space() const { return {series_, project_out_model_, *modes_}; }
};

const Candidate* find(const CandidateList& list, const std::string& effect) {
  const auto candidate = std::find_if(list.testable.begin(), list.testable.end(),
                                      [&](const Candidate& one) { return one.effect == effect; });
  return candidate == list.testable.end() ? nullptr : &*candidate;
}

double best_gain(const Candidate& candidate, const Eigen::VectorXd& residual) {
  double best = 0;
  for (const Candidate::Shape& shape : candidate.shapes) {
    best = std::max(best, shape.chi2_drop(residual));
  }
  return best;
}

TEST_F(CandidatesTest, AreAllEffectsThatTheModelLacksOrItIsSaidWhatTheyNeed) {
  const CandidateList list = found("bias");
  std::map<std::string, int> told{{"bias", 1}};
  for (const Candidate& candidate : list.testable) ++told[candidate.effect];
  for (const Untestable& one : list.untestable) {
    ++told[one.effect];
    EXPECT_FALSE(one.needs.empty()) << one.effect;
  }
  for (const std::string& effect : model::effect_names()) EXPECT_EQ(told[effect], 1) << effect;
  const auto magnetic =
      std::find_if(list.untestable.begin(), list.untestable.end(),
                   [](const Untestable& one) { return one.effect == "magnetic"; });
  ASSERT_NE(magnetic, list.untestable.end());
  EXPECT_EQ(magnetic->needs, "magnetic_ut");
}

TEST_F(CandidatesTest, NeedAnInputThatVaries) {
  const CandidateList list = found("bias", ~fog::InputMask{0});  // columns there, all zero
  EXPECT_EQ(find(list, "magnetic"), nullptr);
  EXPECT_EQ(find(list, "vibration"), nullptr);
}

TEST_F(CandidatesTest, HaveOrthonormalBasesAndShapesWithinTheirBounds) {
  for (const Candidate& candidate : found("bias").testable) {
    ASSERT_FALSE(candidate.shapes.empty()) << candidate.effect;
    for (const Candidate::Shape& shape : candidate.shapes) {
      EXPECT_EQ(shape.term.name, candidate.effect);
      ASSERT_GT(shape.basis.cols(), 0) << candidate.effect;
      const Eigen::MatrixXf product = shape.basis.transpose() * shape.basis;
      EXPECT_TRUE(product.isIdentity(1e-5F)) << candidate.effect;
      const model::CatalogueEntry& entry = model::find_effect(candidate.effect);
      for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
        const double value = shape.term.parameters[i].value;
        EXPECT_LE(value, entry.parameters[i].max_milli / 1000.0 + 1e-9) << candidate.effect;
        if (value == 0 && model::is_optional_part(entry.parameters[i])) continue;
        EXPECT_GE(value, entry.parameters[i].min_milli / 1000.0 - 1e-9) << candidate.effect;
      }
    }
  }
}

// For any true shape, one shape of the grid explains most of it: here a narrow bump at any
// temperature.
TEST_F(CandidatesTest, AreLaidOutSoThatNoShapeIsFarFromOne) {
  const CandidateList list =
      found("bias", kTimeOnly, {model::expression_term("bump = exp(-((T - ?at[-30,50]) / 3)^2)")});
  const Candidate* const candidate = find(list, "bump");
  ASSERT_NE(candidate, nullptr);
  for (double at = -29; at < 50; at += 0.7) {
    const auto truth = "truth = exp(-((T - " + std::to_string(at) + ") / 3)^2)";
    const Eigen::MatrixXd column = series_.regressors(model::expression_term(truth));
    EXPECT_GT(best_gain(*candidate, without_mean(column).columns.col(0).normalized()), 0.85) << at;
  }
}

TEST_F(CandidatesTest, OfWhatTheModelHasAreWhatItCouldGrowTo) {
  const CandidateList list = found("bias,bias_temperature:order=2,thermal_hysteresis:radius=5");
  const Candidate* const polynomial = find(list, "bias_temperature");
  ASSERT_NE(polynomial, nullptr);
  for (const auto& shape : polynomial->shapes) EXPECT_EQ(shape.term.parameters[0].value, 3);
  const Candidate* const loops = find(list, "thermal_hysteresis");
  ASSERT_NE(loops, nullptr);
  for (const auto& shape : loops->shapes) {
    EXPECT_EQ(shape.term.parameters[0].value, 5);
    EXPECT_GT(shape.term.parameters[1].value, 0);
    EXPECT_EQ(shape.basis.cols(), 1);  // the second loop alone
  }
  EXPECT_EQ(find(list, "bias"), nullptr);
}

TEST_F(CandidatesTest, AreExpressionsThatAreOfferedAndNotInTheModel) {
  const std::vector<model::EffectTerm> offered{
      model::expression_term("own = exp(-((T - 5) / 8)^2)"),
      model::expression_term("constant = sin(T)^2 + cos(T)^2")};
  const CandidateList list = found("bias", kTimeOnly, offered);
  ASSERT_NE(find(list, "own"), nullptr);
  EXPECT_TRUE(find(list, "own")->is_expression());
  EXPECT_EQ(find(list, "constant"), nullptr);  // the model's bias does that
  EXPECT_EQ(list.untestable.back().effect, "constant");
  std::vector<model::EffectTerm> terms = model::parse_effects("bias");
  terms.push_back(offered[0]);
  const CandidateList own = find_candidates(space(), terms, {offered[0]}, kTimeOnly, [](double) {});
  EXPECT_EQ(find(own, "own"), nullptr);
  EXPECT_THROW(found("bias", kTimeOnly, {model::expression_term("root = T^0.5")}), InputError);
}

TEST_F(CandidatesTest, TellHowFarTheyAreOnTheWayFrom0To1) {
  double last = 0;
  find_candidates(space(), model::parse_effects("bias"), {}, kTimeOnly, [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
  });
  EXPECT_GT(last, 0.5);
}

TEST_F(CandidatesTest, AreSharpenedTowardsTheTruth) {
  const Eigen::VectorXd residual = residual_of("thermal_lag:tau=700", 40);
  CandidateList list = found("bias");
  const double before = best_gain(*find(list, "thermal_lag"), residual);
  list.testable =
      with_best_shapes(std::move(list.testable), space(), model::parse_effects("bias"), residual);
  const double after = best_gain(*find(list, "thermal_lag"), residual);
  EXPECT_GT(after, before);
  EXPECT_GT(after, 0.985 * residual.squaredNorm()) << before;
}

// Weak effects are tested at the shapes of the test against noise.
TEST_F(CandidatesTest, AreNotSharpenedOnWhatNoiseMightBe) {
  const Eigen::VectorXd residual = residual_of("thermal_lag:tau=700", 9);
  CandidateList list = found("bias");
  const CandidateList before = list;
  list.testable =
      with_best_shapes(std::move(list.testable), space(), model::parse_effects("bias"), residual);
  for (std::size_t i = 0; i < list.testable.size(); ++i) {
    for (std::size_t shape = 0; shape < list.testable[i].shapes.size(); ++shape) {
      EXPECT_EQ(list.testable[i].shapes[shape].term.shape(),
                before.testable[i].shapes[shape].term.shape());
    }
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
