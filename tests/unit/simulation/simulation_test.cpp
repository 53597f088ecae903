// Whole runs: rows, seeds, the truth, and the paper's table.
#include "simulation/simulation.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "recording/recording_writer.hpp"
#include "simulation/row_means.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "unit/simulation/run_helper.hpp"

namespace fogcomp::simulation {
namespace {

std::string csv_of(const WholeRun& result) {
  const std::string path = testing::TempDir() + "simulation_" + std::to_string(getpid()) + ".csv";
  recording::RecordingWriter writer(
      path, recording::RecordingFormat::csv,
      {recording::Column::time_s, recording::Column::temperature_degc, recording::Column::rate_dph},
      recording::kDefaultScaleFactor, 0.1);
  writer.append(
      {result.rows.time_s.data(), result.rows.temperature_degc.data(), result.rows.rate_dph.data()},
      result.rows.rows());
  writer.commit();
  std::string text = read_file(path);
  unlink(path.c_str());
  return text;
}

SimulationOptions with_seed(std::uint64_t seed) {
  SimulationOptions options = coarse();
  options.seed = seed;
  return options;
}

TEST(Simulation, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  const GyroDescription gyro = gyro_of({"bias_step", "light_power"}, "tactical");
  const Programme programme = profile_of("random_steps");
  const std::string first = csv_of(whole_run(gyro, programme, with_seed(7)));
  EXPECT_EQ(first, csv_of(whole_run(gyro, programme, with_seed(7))));
  EXPECT_NE(first, csv_of(whole_run(gyro, programme, with_seed(8))));
}

TEST(Simulation, LeavesAllOtherNoiseBitsAloneWhenASourceOrEffectIsSwitchedOn) {
  const Programme programme = profile_of("paper");
  const WholeRun plain =
      whole_run(gyro_of({"noise:white=0.001,random_walk=0.01"}), programme, coarse());
  const WholeRun more =
      whole_run(gyro_of({"noise:white=0.001,random_walk=0.01,flicker=0.01,outliers=5", "bias_step",
                         "light_power", "shupe:peak=0.1"}),
                programme, coarse());
  ASSERT_EQ(plain.noise_names, (std::vector<std::string>{"white", "random_walk"}));
  ASSERT_EQ(more.noise_names[2], "random_walk");
  EXPECT_EQ(plain.rows.noises_dph[0], more.rows.noises_dph[0]);
  EXPECT_EQ(plain.rows.noises_dph[1], more.rows.noises_dph[2]);
  EXPECT_EQ(plain.rows.temperature_degc, more.rows.temperature_degc);
}

TEST(Simulation, RowsAreTheSumOfTheTruth) {
  SimulationOptions options = coarse();
  options.rate_hz = 3;
  options.earth.latitude_deg = 45;
  const WholeRun result =
      whole_run(gyro_of({"shupe:peak=0.05", "noise:quantization=0"}, "tactical"),
                profile_of("axis_flips"), options);
  for (std::size_t row = 0; row < result.rows.rows(); row += 97) {
    double sum = result.rows.input_rate_dph[row];
    for (const auto& effect : result.rows.effects_dph) sum += effect[row];
    for (const auto& noise : result.rows.noises_dph) sum += noise[row];
    ASSERT_NEAR(result.rows.rate_dph[row], sum, 1e-9);
  }
}

TEST(Simulation, LongRowsAreTheMeansOfShortOnes) {
  const GyroDescription gyro = gyro_of({"shupe:peak=0.05"}, "paper");
  GyroDescription quiet = gyro;
  quiet.set("test", "noise", {"white=0", "flicker=0", "outliers=0"});
  const Programme programme = parse_profile("soak 5 min\nramp to 30 degC at 1 degC/min\n", "t", 1);
  SimulationOptions fast = coarse();
  fast.rate_hz = 200;
  const WholeRun short_rows = whole_run(quiet, programme, fast);
  const WholeRun long_rows = whole_run(quiet, programme, coarse());
  ASSERT_EQ(short_rows.rows.rows(), 900 * 200U);
  ASSERT_EQ(long_rows.rows.rows(), 90U);
  for (std::size_t row = 0; row < 90; ++row) {
    double rate = 0;
    double degc = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
      rate += short_rows.rows.rate_dph[2000 * row + i] / 2000;
      degc += short_rows.rows.temperature_degc[2000 * row + i] / 2000;
    }
    ASSERT_NEAR(long_rows.rows.rate_dph[row], rate, 1e-9);
    ASSERT_NEAR(long_rows.rows.temperature_degc[row], degc, 1e-9);
  }
}

TEST(Simulation, HasARowForEveryPeriodAtAnyRate) {
  const Programme programme = parse_profile("soak 1 h\n", "test", 1);
  for (const double rate_hz : {0.01, 0.1, 0.3, 1.0, 7.0, 99.9}) {
    SimulationOptions options = coarse();
    options.rate_hz = rate_hz;
    const WholeRun result = whole_run(gyro_of({"bias"}), programme, options);
    EXPECT_EQ(result.rows.rows(), static_cast<std::size_t>(3600 * rate_hz + 1e-6)) << rate_hz;
    EXPECT_NEAR(result.rows.time_s[1], 1 / rate_hz, 1e-9);
    EXPECT_NEAR(result.rows.rate_dph.back(), 0.5, 1e-9);
  }
}

TEST(RowMeans, IntegrateStraightAndHeldChannelsExactly) {
  using Between = RowMeans::Between;
  RowMeans means(1, 2.5, {Between::straight, Between::held}, {0, 0});
  std::vector<double> out(2);
  double value = 0;
  std::vector<std::vector<double>> rows;
  while (rows.size() < 2) {
    while (means.needs_step()) means.push({value += 1, value});
    means.next_row(out.data());
    rows.push_back(out);
  }
  EXPECT_NEAR(rows[0][0], 1.25, 1e-12);
  EXPECT_NEAR(rows[1][0], 3.75, 1e-12);
  EXPECT_NEAR(rows[0][1], (0 + 1 + 0.5 * 2) / 2.5, 1e-12);
  EXPECT_NEAR(rows[1][1], (0.5 * 2 + 3 + 4) / 2.5, 1e-12);
}

TEST(EarthRate, FollowsLatitudeAndAxis) {
  EarthRate earth;
  EXPECT_EQ(input_rate_dph({}, 0, earth, Axis::up), 0);
  earth.latitude_deg = 34.27;
  EXPECT_NEAR(input_rate_dph({}, 0, earth, Axis::up), 8.47, 0.005);  // Xi'an
  EXPECT_NEAR(input_rate_dph({}, 0, earth, Axis::down), -8.47, 0.005);
  EXPECT_NEAR(input_rate_dph({}, 0, earth, Axis::north), 12.43, 0.005);
  EXPECT_EQ(input_rate_dph({}, 0, earth, Axis::east), 0);
}

TEST(Sensor, ReadsInStepsOfItsResolutionAndLags) {
  SimulationOptions options = coarse();
  options.rate_hz = 1;
  const Programme programme =
      parse_profile("soak 10 min\nramp to 60 degC at 1 degC/min\nsoak 10 min\n", "test", 1);
  for (const std::string step : {"1", "0.5", "0.0625", "0.01"}) {
    const WholeRun result = whole_run(gyro_of({"sensor:resolution_k=" + step}), programme, options);
    for (const double degc : result.rows.temperature_degc) {
      const double steps = degc / std::stod(step);
      ASSERT_NEAR(steps, std::round(steps), 1e-6) << step;
    }
  }
  const WholeRun prompt =
      whole_run(gyro_of({"sensor:lag_s=0,resolution_k=0,noise_k=0"}), programme, options);
  const WholeRun late =
      whole_run(gyro_of({"sensor:lag_s=60,resolution_k=0,noise_k=0"}), programme, options);
  // What a sensor with a time constant of 60 s reads in a ramp is a minute old.
  EXPECT_NEAR(late.rows.temperature_degc[2900], prompt.rows.temperature_degc[2840], 0.05);
}

struct TableRow {
  const char* segment;
  double mean_dph;
  double std_dph;
};
// Table 1 of the paper, raw columns (data/paper_tables.csv).
constexpr TableRow kPaper[] = {{"20", 0.719659, 0.028345},  {"20~-40", 0.646126, 0.058365},
                               {"-40", 0.616971, 0.023955}, {"-40~60", 0.757383, 0.065029},
                               {"60", 0.662305, 0.023636},  {"60~20", 0.662601, 0.059026}};
constexpr TableRow kPaperAll = {"all", 0.689201, 0.064910};

class PaperPreset : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PaperPreset, GivesTheTableOfThePaper) {
  const Programme programme = profile_of("paper");
  const WholeRun result = whole_run(gyro_of({}, "paper"), programme, with_seed(GetParam()));
  ASSERT_EQ(result.rows.rows(), 5955U);
  const auto expect_like = [&](const TableRow& expected, double mean_room, double std_room) {
    double sum = 0;
    double squares = 0;
    double count = 0;
    std::size_t leg = 0;
    for (std::size_t row = 0; row < result.rows.rows(); ++row) {
      while (result.rows.time_s[row] >= programme.legs[leg].end_s) ++leg;
      const std::string segment = expected.segment;
      if (segment != "all" && programme.legs[leg].segment != segment) continue;
      sum += result.rows.rate_dph[row];
      squares += result.rows.rate_dph[row] * result.rows.rate_dph[row];
      count += 1;
    }
    const double mean = sum / count;
    EXPECT_NEAR(mean, expected.mean_dph, mean_room) << expected.segment;
    EXPECT_NEAR(std::sqrt(squares / count - mean * mean), expected.std_dph, std_room)
        << expected.segment;
  };
  for (const TableRow& row : kPaper) expect_like(row, 0.02, 0.02);
  expect_like(kPaperAll, 0.02, 0.1 * kPaperAll.std_dph);
}

INSTANTIATE_TEST_SUITE_P(Seeds, PaperPreset, testing::Values(1, 2, 3, 4, 5));

std::string gyro_error(const std::vector<std::string>& options) {
  try {
    gyro_of(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GyroDescription, SaysWhatIsWrongWithAnOption) {
  EXPECT_EQ(gyro_error({"shuppe"}),
            "test: no effect or part 'shuppe' (did you mean 'shupe'?); fogcomp simulate --list "
            "shows them");
  EXPECT_EQ(gyro_error({"shupe:peek=1"}),
            "test: shupe has no parameter 'peek' (did you mean 'peak'?); it has peak, scale, "
            "asymmetry_m");
  EXPECT_EQ(gyro_error({"shupe:peak"}), "test: 'peak' is not of the form name=value");
  EXPECT_EQ(gyro_error({"shupe:peak=-1"}),
            "test: shupe: peak '-1' is not a number from 0 to 1e+06 deg/h");
  EXPECT_EQ(gyro_error({"coil:layers=40.5"}), "test: coil: layers '40.5' is not a whole number");
  EXPECT_EQ(gyro_error({"shupe:peak=nan"}),
            "test: shupe: peak 'nan' is not a number from 0 to 1e+06 deg/h");
  EXPECT_EQ(gyro_error({"coil:winding=quadrupol"}),
            "test: coil: winding 'quadrupol' is not one of single, dipole, quadrupole, octupole "
            "(did you mean 'quadrupole'?)");
}

TEST(GyroDescription, RefusesACoilWhoseFibreDoesNotFit) {
  EXPECT_THROW(gyro_of({"coil:turns=200"}).coil(), InputError);
}

TEST(GyroDescription, ReadsEveryReadyMadePresetAndNamesABadLine) {
  for (const EmbeddedFile& file : ready_made_presets()) {
    const GyroDescription gyro = gyro_of({}, file.name);
    EXPECT_FALSE(gyro.effects().empty());
    EXPECT_GT(gyro.coil().fibre_length_m(), 100);
  }
  GyroDescription gyro;
  try {
    gyro.apply_preset("# comment\nbias value_dph=1\nsensor lag=3\n", "my.gyro");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 10), "my.gyro:3:");
  }
}

TEST(GyroDescription, SwitchesEffectsOff) {
  GyroDescription gyro = gyro_of({}, "paper");
  const std::size_t before = gyro.effects().size();
  gyro.remove("test", "warm_up");
  EXPECT_EQ(gyro.effects().size(), before - 1);
  EXPECT_THROW(gyro.remove("test", "warm_up"), InputError);
}

}  // namespace
}  // namespace fogcomp::simulation
