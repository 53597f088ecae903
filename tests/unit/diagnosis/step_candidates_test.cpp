#include "diagnosis/step_candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fit/noise_weighted_fit.hpp"
#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kJump_dph = 0.15;  // six times the noise of a row

// Steps of a recording whose rate jumps by `jump_dph` at a fraction of it.
struct Placed {
  std::vector<Candidate::Shape> shapes;
  std::vector<Candidate::Shape> sharp;  // those of them that no change over minutes explains
  double jump_s = 0;
  double row_s = 0;

  bool has_the_jump() const { return have_the_jump(shapes) && have_the_jump(sharp); }
  bool have_the_jump(const std::vector<Candidate::Shape>& some) const {
    return std::any_of(some.begin(), some.end(), [&](const Candidate::Shape& shape) {
      return std::abs(shape.term.parameters[0].value - jump_s) <= row_s;
    });
  }
};

// `missing`: an effect of the gyro that the model lacks, or "". `takes_s`: the rate changes along a
// line instead.
Placed place(double jump_dph, double fraction, const std::string& missing, double takes_s = 0) {
  recording::Recording recording =
      fog::test::thinned(fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1), 4);
  model::Model model = fog::test::truth();
  model.terms.erase(
      std::remove_if(model.terms.begin(), model.terms.end(),
                     [&](const model::EffectTerm& term) { return term.name == missing; }),
      model.terms.end());
  const auto at = static_cast<std::size_t>(fraction * static_cast<double>(recording.rows()));
  for (std::size_t i = at; i < recording.rows(); ++i) {
    const double since_s = recording.time_s[i] - recording.time_s[at];
    recording.rate_dph[i] += since_s < takes_s ? jump_dph * since_s / takes_s : jump_dph;
  }
  DiagnosisData data(model, {runs::run_of(recording, {model.average_s})});
  const series::Rows& rows = data.series().rows();
  const fit::NoiseWeightedFit fit =
      fit::fit_rows(data.series(), model.terms, fit::run_offset_columns(rows));
  const Residualizer residualizer(rows, fit);
  const VisibleStructure smooth = visible_structure(rows, residualizer);
  Placed placed;
  const judge::ModeSpace modes(fit::judged_rows(rows, fit, {fit.linear(), 0}));
  const ProjectOutModel project_out_model = [&](const Eigen::MatrixXd& columns) {
    return residualizer(columns);
  };
  const ShapeSpace space{data.series(), project_out_model, modes};
  const std::vector<Candidate::Shape> grid =
      step_shapes(space, model::parse_effects("bias_step")[0]);
  placed.shapes = placed_steps(grid, space, residualizer, smooth.all);
  EXPECT_EQ(placed.shapes.size(), grid.size());
  placed.sharp = without_gradual_steps(placed.shapes, rows, fit);
  placed.jump_s = recording.time_s[at];
  placed.row_s = rows.row_s;
  return placed;
}

TEST(StepCandidates, AreMovedToTheRowOfAJumpWhereverItIs) {
  for (const double fraction : {0.21, 0.395, 0.5, 0.87}) {
    const Placed placed = place(kJump_dph, fraction, "");
    EXPECT_TRUE(placed.has_the_jump()) << fraction;
  }
}

// An effect that is missing as well has no edges, however large it is.
TEST(StepCandidates, AreMovedToTheJumpAlthoughALargeEffectIsMissing) {
  for (const double fraction : {0.395, 0.5}) {
    const Placed placed = place(1.5 * kJump_dph, fraction, "temperature_rate");
    EXPECT_TRUE(placed.has_the_jump()) << fraction;
  }
}

TEST(StepCandidates, AreNoneWhereAChangeTakesMinutes) {
  const Placed gradual = place(4 * kJump_dph, 0.5, "", 400);
  const auto is_near = [&](const Candidate::Shape& shape) {
    const double away_s = shape.term.parameters[0].value - gradual.jump_s;
    return away_s > -60 && away_s < 460;
  };
  EXPECT_TRUE(std::any_of(gradual.shapes.begin(), gradual.shapes.end(), is_near));
  EXPECT_TRUE(std::none_of(gradual.sharp.begin(), gradual.sharp.end(), is_near));
}

TEST(StepCandidates, StayOnTheGridWhereNothingIsMissing) {
  const Placed none = place(0, 0.5, "");
  EXPECT_EQ(none.sharp.size(), none.shapes.size());
  const std::size_t interval = none.shapes[1].row - none.shapes[0].row;
  for (std::size_t i = 1; i < none.shapes.size(); ++i) {
    EXPECT_LE(none.shapes[i].row - none.shapes[i - 1].row - interval + 1, 2U);
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
