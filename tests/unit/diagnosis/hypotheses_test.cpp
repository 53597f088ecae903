#include "diagnosis/hypotheses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "diagnosis/decision_rules.hpp"
#include "model/effect_list.hpp"

namespace fogcomp::diagnosis {
namespace {

// Hypotheses for three orthogonal effects, the first explaining most.
std::vector<Hypothesis> hypotheses_of(const std::array<const char*, 3>& effects) {
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(50, 3);
  fit::ExplainedSpace space(axes * Eigen::Vector3d(60, 40, 40));
  std::vector<Candidate> candidates;
  RegressorBasis regressors;
  for (const char* effect : effects) {
    const model::EffectTerm term = model::parse_effects(effect)[0];
    const auto axis = static_cast<Eigen::Index>(candidates.size());
    candidates.push_back({term.name, {{term, axes.col(axis).cast<float>()}}});
    regressors.push_back({space.add(candidates.back().shapes[0].basis)});
  }
  space.finish();
  return find_hypotheses(space, candidates, regressors);
}

// Whether the set of all three is flexible enough to imitate.
bool are_pliable(const std::array<const char*, 3>& effects) {
  for (const Hypothesis& h : hypotheses_of(effects)) {
    if (h.effects() == 3) return h.free_shape;
  }
  ADD_FAILURE() << "no set of three";
  return false;
}

// A set of three is reached from each of its pairs.
TEST(Hypotheses, CountASetOnce) {
  std::set<std::set<std::size_t>> sets;
  double probability = 0;
  for (const Hypothesis& h : hypotheses_of({"thermal_hysteresis", "aging", "temperature_rate"})) {
    std::set<std::size_t> set;
    for (const Hypothesis::Part& part : h.parts) set.insert(part.candidate);
    EXPECT_TRUE(sets.insert(set).second) << set.size() << " effects";
    probability += h.probability;
  }
  EXPECT_NEAR(probability, 1, 1e-12);
}

TEST(Hypotheses, ArePliableWhereTemperatureAndTimeDriveThemAndAFreeShapeLeads) {
  EXPECT_TRUE(are_pliable({"thermal_hysteresis", "aging", "temperature_rate"}));
  EXPECT_FALSE(are_pliable({"temperature_rate", "thermal_hysteresis", "aging"}));
  EXPECT_FALSE(are_pliable({"thermal_hysteresis", "aging", "magnetic"}));
}

// Candidates of one column each, with one shape unless `shapes` has more: directions of a space,
// and a residual in it.
class Directions {
 public:
  explicit Directions(const Eigen::VectorXd& residual) : size_(residual.size()), space_(residual) {}

  void add(const std::string& effect, const std::vector<Eigen::VectorXd>& shapes) {
    const model::EffectTerm term = model::parse_effects(effect)[0];
    candidates_.push_back({term.name, {}});
    for (const Eigen::VectorXd& shape : shapes) {
      candidates_.back().shapes.push_back({term, shape.normalized().cast<float>()});
    }
    regressors_.emplace_back();
    for (const Candidate::Shape& shape : candidates_.back().shapes) {
      regressors_.back().push_back(space_.add(shape.basis));
    }
  }
  Eigen::VectorXd axis(Eigen::Index i) const { return Eigen::VectorXd::Unit(size_, i); }

  std::vector<Hypothesis> found() {
    space_.finish();
    return find_hypotheses(space_, candidates_, regressors_);
  }
  const fit::ExplainedSpace& space() const { return space_; }
  const RegressorBasis& regressors() const { return regressors_; }

 private:
  Eigen::Index size_;
  fit::ExplainedSpace space_;
  std::vector<Candidate> candidates_;
  RegressorBasis regressors_;
};

Eigen::VectorXd residual_of(std::initializer_list<double> first, Eigen::Index size = 40) {
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(size);
  std::copy(first.begin(), first.end(), residual.begin());
  return residual;
}

std::vector<std::size_t> candidates_of(const Hypothesis& h) {
  std::vector<std::size_t> numbers;
  for (const auto& part : h.parts) numbers.push_back(part.candidate);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(Hypotheses, NameTheSetThatExplainsWhatIsThere) {
  Directions two(residual_of({20, 15, 1, 1}));
  two.add("temperature_rate", {two.axis(0)});
  two.add("temperature_rate_product", {two.axis(1)});
  two.add("aging", {two.axis(2)});
  two.add("warm_up", {two.axis(3)});
  const auto hypotheses = two.found();
  ASSERT_FALSE(hypotheses.empty());
  EXPECT_EQ(candidates_of(hypotheses[0]), (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(hypotheses[0].chi2_drop, 625, 1e-3);
  EXPECT_GT(hypotheses[0].probability, 0.9);
  EXPECT_EQ(leading_candidate(two.space(), two.regressors(), hypotheses[0]), 0U);
  double sum = 0;
  double last = 1;
  for (const Hypothesis& h : hypotheses) {
    EXPECT_LE(h.probability, last);
    last = h.probability;
    sum += h.probability;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(Hypotheses, GiveRivalsThatLookAlikeTheSameProbability) {
  Directions rivals(residual_of({20, 0.1}));
  rivals.add("temperature_rate", {rivals.axis(0)});
  rivals.add("temperature_rate_product", {rivals.axis(0) + 1e-3 * rivals.axis(1)});
  const auto hypotheses = rivals.found();
  ASSERT_GE(hypotheses.size(), 2U);
  EXPECT_NEAR(hypotheses[0].probability, hypotheses[1].probability, 0.1);
}

TEST(Hypotheses, TakeTheShapeThatExplainsMostAndCountThatOthersWereTried) {
  Directions one(residual_of({12, 9}));
  one.add("thermal_lag", {one.axis(1), one.axis(0), one.axis(0) + one.axis(1), one.axis(5)});
  const auto hypotheses = one.found();
  ASSERT_FALSE(hypotheses.empty());
  ASSERT_EQ(hypotheses[0].parts.size(), 1U);
  EXPECT_EQ(hypotheses[0].parts[0].shape, 2U);
  EXPECT_NEAR(hypotheses[0].chi2_drop, 21 * 21 / 2.0, 1e-6);
  EXPECT_LT(hypotheses[0].log_evidence, fit::log_evidence(hypotheses[0].chi2_drop, 1));
}

TEST(Hypotheses, BelieveAnEventOnlyWithFarMoreThanNoiseBrings) {
  for (const double sigmas : {0.9, 1.1}) {
    Directions step(residual_of({sigmas * std::sqrt(rules::kMinStepChi2Drop)}));
    step.add("bias_step", {step.axis(0)});
    EXPECT_EQ(step.found().size(), sigmas > 1 ? 1U : 0U);
  }
}

TEST(Hypotheses, OfNothingAreFinite) {
  Directions nothing(residual_of({}));
  nothing.add("temperature_rate", {nothing.axis(0)});
  nothing.add("thermal_lag", {nothing.axis(1), nothing.axis(2)});
  for (const Hypothesis& h : nothing.found()) {
    EXPECT_TRUE(std::isfinite(h.probability) && std::isfinite(h.log_evidence));
    EXPECT_EQ(h.chi2_drop, 0);
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
