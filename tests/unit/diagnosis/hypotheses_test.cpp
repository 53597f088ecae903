#include "diagnosis/hypotheses.hpp"

#include <gtest/gtest.h>

#include <array>

#include "identification/effect_list.hpp"

namespace {

// Of three effects at right angles, the first explaining most: can the set be bent to imitate?
bool are_pliable(const std::array<const char*, 3>& effects) {
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
  for (const fogcomp::Hypothesis& h : fogcomp::find_hypotheses(space, candidates, library)) {
    if (h.effects() == 3) return h.pliable;
  }
  ADD_FAILURE() << "no set of three";
  return false;
}

TEST(Hypotheses, ArePliableWhereTemperatureAndTimeDriveThemAndAFreeShapeLeads) {
  EXPECT_TRUE(are_pliable({"thermal_hysteresis", "aging", "temperature_rate"}));
  EXPECT_FALSE(are_pliable({"temperature_rate", "thermal_hysteresis", "aging"}));
  EXPECT_FALSE(are_pliable({"thermal_hysteresis", "aging", "magnetic"}));
}

}  // namespace
