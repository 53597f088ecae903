// A small run of the whole pipeline: fewer epochs and models than `fogcomp paper` has by default.
#include "research/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "research/printed_tables.hpp"
#include "support/text.hpp"

namespace {

fogcomp::research::StudySettings small_settings() {
  fogcomp::research::StudySettings settings;
  settings.epochs = 1500;
  settings.iterations = 50;
  settings.models = {"polynomial", "bp", "pso-bp", "effects", "effects+network"};
  return settings;
}

const fogcomp::research::Study& study() {
  static const fogcomp::research::Study result = fogcomp::research::run_study(small_settings());
  return result;
}

TEST(PaperStudy, HasThePapersRowsAndSegments) {
  EXPECT_EQ(study().run.truth_dph.size(), 5955);
  Eigen::Index rows = 0;
  for (const fogcomp::research::PrintedSegment& printed : fogcomp::research::kPrinted) {
    const Eigen::VectorXd& raw = study().run.series.rows().drift_dph;
    const Eigen::VectorXd values = study().of_segment(printed.name, raw);
    if (std::string(printed.name) != "all") rows += values.size();
    EXPECT_NEAR(fogcomp::research::mean_and_std(values).mean_dph, printed.raw_mean, 0.02)
        << printed.name;
  }
  EXPECT_EQ(rows, 5955);
}

TEST(PaperStudy, TruthIsWhatIsMeasuredLessNoise) {
  const Eigen::VectorXd noise = study().run.series.rows().drift_dph - study().run.truth_dph;
  const fogcomp::research::MeanStd left = fogcomp::research::mean_and_std(noise);
  EXPECT_NEAR(left.mean_dph, 0, 0.005);
  EXPECT_NEAR(left.std_dph, study().run.noise_floor_dph, 0.15 * study().run.noise_floor_dph);
}

TEST(PaperStudy, NetworksOfTimeAndTemperatureFitTheirRunAndFailOnOthers) {
  for (const char* name : {"bp", "pso-bp"}) {
    const fogcomp::research::ModelResult& model = study().model(name);
    EXPECT_LT(model.own.residual.std_dph, 0.5 * study().raw.std_dph) << name;
    for (const fogcomp::research::Score& held_out : model.held_out) {
      EXPECT_GT(held_out.truth_rms_dph, 2 * model.own.truth_rms_dph) << name;
      EXPECT_GT(held_out.truth_rms_dph, 0.03) << name;
    }
  }
}

// An error of a third of a row's noise increases its rms by only 5 %.
TEST(PaperStudy, EffectsHoldOnProgrammesTheyNeverSaw) {
  const double noise_dph = study().run.noise_floor_dph;
  for (const char* name : {"effects", "effects+network"}) {
    const fogcomp::research::ModelResult& model = study().model(name);
    EXPECT_LT(model.own.truth_rms_dph, noise_dph / 5) << name;
    ASSERT_FALSE(model.held_out.empty()) << name;
    for (std::size_t run = 0; run < model.held_out.size(); ++run) {
      EXPECT_LT(model.held_out[run].truth_rms_dph, noise_dph / 3) << name;
      EXPECT_LT(model.held_out[run].truth_rms_dph,
                study().model("polynomial").held_out[run].truth_rms_dph / 2)
          << name;
    }
  }
}

TEST(PaperStudy, EveryDenoiserTakesMostOfTheNoiseAway) {
  for (const fogcomp::research::DenoiserResult& denoiser : study().denoisers) {
    EXPECT_LT(denoiser.truth_rms_dph, 0.5 * study().run.noise_floor_dph) << denoiser.name;
  }
}

TEST(PaperStudy, GyrosSideBySideAreTheGyrosByThemselves) {
  fogcomp::research::StudySettings settings = small_settings();
  settings.epochs = 100;
  settings.iterations = 2;
  settings.models = {"bp", "polynomial"};
  const auto together = fogcomp::research::study_gyros(settings, 3, [](double) {});
  ASSERT_EQ(together.size(), 3U);
  settings.seed = 3;
  const fogcomp::research::Study alone = fogcomp::research::run_study(settings);
  EXPECT_EQ(together[2].model("bp").own_dph, alone.model("bp").own_dph);
  EXPECT_EQ(together[2].model("polynomial").own_dph, alone.model("polynomial").own_dph);
  EXPECT_NE(together[1].model("bp").own_dph, alone.model("bp").own_dph);
}

TEST(PrintedTables, AreThoseOfThePaper) {
  std::ifstream file(std::string(FOG_SOURCE_DIR) + "/../shared/data/paper_tables.csv");
  if (!file) GTEST_SKIP() << "no recording of the paper's tables beside the project";
  std::string line;
  std::size_t row = 0;
  while (std::getline(file, line)) {
    const auto fields = fogcomp::split(line, ',');
    if (line[0] == '#' || fields[0] == "segment") continue;
    ASSERT_LT(row, fogcomp::research::kPrinted.size());
    const fogcomp::research::PrintedSegment& ours = fogcomp::research::kPrinted[row++];
    EXPECT_EQ(fields[0], ours.name);
    const double values[] = {ours.raw_mean, ours.raw_std, ours.denoised_mean, ours.denoised_std,
                             ours.bp_mean,  ours.bp_std,  ours.pso_bp_mean,   ours.pso_bp_std};
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(fogcomp::parse_number(fields[i + 1]), values[i]) << ours.name << " " << i;
    }
  }
  EXPECT_EQ(row, fogcomp::research::kPrinted.size());
}

}  // namespace
