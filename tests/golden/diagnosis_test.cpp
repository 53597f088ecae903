#include "diagnosis/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/ladder.hpp"
#include "identification/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/typical_effects.hpp"
#include "unit/identification/simulated_gyro.hpp"

namespace {

using fogcomp::Diagnosis;
using fogcomp::Model;
using fogcomp::Verdict;

constexpr fog::test::RowNoise kNoise{0.024, 0.004, 600};

std::vector<fogcomp::EffectTerm> basic() {
  return {fog::test::natural_term("bias", {}, {0.7}),
          fog::test::natural_term("bias_temperature", {2}, {-4e-4, -3e-5}),
          fog::test::natural_term("temperature_rate", {}, {0.12})};
}

Model model_of(const std::vector<fogcomp::EffectTerm>& terms) {
  Model model = fog::test::paper_like_model();
  model.network = {};
  model.terms = terms;
  return model;
}

// What the coil does without the board's delays, and noise.
fogcomp::Recording recording_with(const std::vector<fogcomp::EffectTerm>& hidden,
                                  std::uint64_t seed) {
  std::vector<fogcomp::EffectTerm> terms = basic();
  terms.insert(terms.end(), hidden.begin(), hidden.end());
  const Model model = model_of(terms);
  fogcomp::Recording recording = fog::test::recording_of(model_of({}), kNoise, seed);
  fogcomp::SignalSeries series(model, fogcomp::Phase::zero);
  series.add(fogcomp::make_blocks(recording));
  for (const fogcomp::EffectTerm& term : terms) {
    const Eigen::MatrixXd regressors = series.regressors(term);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
      for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
        recording.rate_dph[row] +=
            term.coefficients_dph[i] *
            regressors(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
      }
    }
  }
  return recording;
}

Diagnosis diagnosed(const std::string& effects, const fogcomp::Recording& recording) {
  const Model model = model_of(fogcomp::parse_effects(effects));
  fogcomp::DiagnosisData data(model);
  data.add(recording);
  return fogcomp::diagnose(model, data);
}

constexpr const char* kBasic = "bias,bias_temperature:order=2,temperature_rate";

TEST(Diagnosis, NamesNothingWhereNothingIsMissing) {
  int named = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    named += diagnosed(kBasic, recording_with({}, seed)).verdict != Verdict::none ? 1 : 0;
  }
  EXPECT_LE(named, 1);
}

TEST(Diagnosis, NamesTheEffectThatIsMissing) {
  const struct {
    fogcomp::EffectTerm term;
    const char* declared;
  } kCases[] = {
      {fog::test::natural_term("polarization_ripple", {13, 0}, {0.012, 0.006}), kBasic},
      {fog::test::natural_term("thermal_hysteresis", {6, 0}, {0.02}), kBasic},
      {fog::test::natural_term("temperature_rate_product", {}, {9e-4}), kBasic},
      {basic()[2], "bias,bias_temperature:order=2"},
  };
  for (const auto& one : kCases) {
    const bool hidden = one.term.name != "temperature_rate";
    const Diagnosis diagnosis =
        diagnosed(one.declared, recording_with(hidden ? std::vector<fogcomp::EffectTerm>{one.term}
                                                      : std::vector<fogcomp::EffectTerm>{},
                                               3));
    EXPECT_EQ(diagnosis.verdict, Verdict::missing_effect) << one.term.name;
    EXPECT_EQ(diagnosis.effect, one.term.name);
    ASSERT_FALSE(diagnosis.candidates.empty());
    EXPECT_LT(diagnosis.candidates[0].rms_after_dph, diagnosis.residual_rms_dph);
    EXPECT_LT(diagnosis.chance, 1e-6);
  }
}

// Beside a rate term, a lagged rate and a transient gradient are the same two columns.
TEST(Diagnosis, SaysWhichEffectsTheDataCannotTellApart) {
  const Diagnosis diagnosis = diagnosed(
      kBasic, recording_with({fog::test::natural_term("thermal_lag", {1500}, {0.12})}, 5));
  ASSERT_EQ(diagnosis.verdict, Verdict::ambiguous);
  for (const char* const effect : {"thermal_lag", "shupe"}) {
    EXPECT_NE(std::find(diagnosis.confusable.begin(), diagnosis.confusable.end(), effect),
              diagnosis.confusable.end())
        << effect;
  }
  ASSERT_TRUE(diagnosis.experiment.has_value());
  EXPECT_TRUE(diagnosis.experiment->profile.empty()) << diagnosis.experiment->sentence;
}

TEST(Diagnosis, CallsUnknownWhatNoEffectExplains) {
  fogcomp::Recording recording = recording_with({}, 7);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.rate_dph[i] += 0.03 * std::sin(recording.time_s[i] / 290);
  }
  const Diagnosis diagnosis = diagnosed(kBasic, recording);
  EXPECT_EQ(diagnosis.verdict, Verdict::unknown);
  EXPECT_NEAR(diagnosis.fast.line_period_s, 2 * M_PI * 290, 60);
}

TEST(Diagnosis, SaysWhatARunCannotShow) {
  const Diagnosis diagnosis = diagnosed(kBasic, recording_with({}, 1));
  const auto magnetic =
      std::find_if(diagnosis.untestable.begin(), diagnosis.untestable.end(),
                   [](const fogcomp::Untestable& one) { return one.effect == "magnetic"; });
  ASSERT_NE(magnetic, diagnosis.untestable.end());
  EXPECT_EQ(magnetic->needs, "magnetic_ut");
}

TEST(Diagnosis, RefusesTooFewRows) {
  fogcomp::Recording recording = recording_with({}, 1);
  recording.time_s.resize(50);
  recording.temperature_degc.resize(50);
  recording.rate_dph.resize(50);
  EXPECT_THROW(diagnosed(kBasic, recording), fogcomp::InputError);
}

TEST(Ladder, FindsTwoEffectsAndStops) {
  const Model model = model_of(fogcomp::parse_effects("bias,bias_temperature:order=2"));
  fogcomp::DiagnosisData data(model);
  data.add(recording_with({fog::test::natural_term("polarization_ripple", {13, 0}, {0.02, 0})}, 2));
  const fogcomp::Ladder ladder = fogcomp::walk_ladder(model, data, 4);
  std::vector<std::string> added = ladder.added();
  std::sort(added.begin(), added.end());
  EXPECT_EQ(added, (std::vector<std::string>{"polarization_ripple", "temperature_rate"}));
  EXPECT_LT(ladder.steps.back().rms_after_dph,
            1.05 * std::hypot(kNoise.white_dph, kNoise.slow_dph));
}

}  // namespace
