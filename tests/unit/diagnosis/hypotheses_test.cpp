#include "diagnosis/hypotheses.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "identification/effect_list.hpp"

namespace {

// What competes where three effects at right angles are there, the first explaining most.
std::vector<fogcomp::Hypothesis> hypotheses_of(const std::array<const char*, 3>& effects) {
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(50, 3);
  fogcomp::ExplainedSpace space(axes * Eigen::Vector3d(60, 40, 40));
  std::vector<fogcomp::Candidate> candidates;
  fogcomp::Library library;
  for (const char* effect : effects) {
    const fogcomp::EffectTerm term = fogcomp::parse_effects(effect)[0];
    const Eigen::MatrixXd basis = axes.col(static_cast<Eigen::Index>(candidates.size()));
    candidates.push_back({term.name, {{term, basis}}});
    library.push_back({space.add(basis)});
  }
  space.finish();
  return fogcomp::find_hypotheses(space, candidates, library);
}

// Can the set of all three be bent to imitate?
bool are_pliable(const std::array<const char*, 3>& effects) {
  for (const fogcomp::Hypothesis& h : hypotheses_of(effects)) {
    if (h.effects() == 3) return h.pliable;
  }
  ADD_FAILURE() << "no set of three";
  return false;
}

// A set of three is reached from each of its pairs.
TEST(Hypotheses, CountASetOnce) {
  std::set<std::set<std::size_t>> sets;
  double probability = 0;
  for (const fogcomp::Hypothesis& h :
       hypotheses_of({"thermal_hysteresis", "aging", "temperature_rate"})) {
    std::set<std::size_t> set;
    for (const fogcomp::Hypothesis::Part& part : h.parts) set.insert(part.candidate);
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

}  // namespace
