// The use cases as a program of one's own calls them: requests and results, files in a folder, no
// command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "board/table_files.hpp"
#include "core/frames/compact_frame.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"
#include "support/text.hpp"
#include "support/typical_effects.hpp"
#include "unit/recording/temporary_file.hpp"
#include "workflow/add.hpp"
#include "workflow/apply.hpp"
#include "workflow/calibrate.hpp"
#include "workflow/compare.hpp"
#include "workflow/diagnose.hpp"
#include "workflow/paper.hpp"
#include "workflow/recordings.hpp"
#include "workflow/replay.hpp"
#include "workflow/simulate.hpp"

namespace fogcomp::workflow {
namespace {

// Recordings of one simulated gyro.
class UseCases : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    simulate("paper", 1, "run.csv");
    simulate("reversed", 2, "second.csv");
  }

  static std::string path(const std::string& name) { return recording::temporary_path(name); }

  static void simulate(const std::string& profile, std::uint64_t seed, const std::string& name) {
    SimulateRequest request;
    request.profile = profile;
    request.options.seed = seed;
    request.options.grid.axial_cells = 1;
    SimulatedChamber chamber(request);
    recording::RecordingWriter writer(path(name), request.format, chamber.columns(),
                                      recording::kDefaultScaleFactor, request.options.rate_hz);
    chamber.run([&](const simulation::RowChunk& chunk) {
      std::vector<const double*> values;
      for (const recording::Column column : chamber.columns())
        values.push_back(chunk[column].data());
      writer.append(values, chunk.rows());
    });
    writer.commit();
  }

  static FitRequest static_fit() {
    FitRequest request;
    request.runs = {path("run.csv")};
    request.effects = "bias,bias_temperature";
    request.average_s = 30;
    return request;
  }

  // The model without rate terms: what it lacks is to be found.
  static std::string static_model() {
    const std::string file = path("static.model");
    if (!std::filesystem::exists(file)) model::save_model(fit(static_fit()).model, file);
    return file;
  }
};

TEST_F(UseCases, ALimitOfTheGyroIsPartOfItsCalibration) {
  FitRequest request = static_fit();
  request.reading.limits.range_dps = 200;
  const model::Model model = fit(request).model;
  EXPECT_EQ(model.limits.range_dps, 200);
  EXPECT_EQ(model.limits.max_acceleration_dps2, 20'000);
  const ExportOutcome board = board_header(model, "gyro.model", {}, false);
  EXPECT_NE(board.header.find("/* range (+-200 deg/s) */"), std::string::npos);
  EXPECT_TRUE(board.notes.empty());
  board::BoardSettings given;
  given.limits.range_dps = 90;
  const ExportOutcome narrow = board_header(model, "gyro.model", given, false);
  EXPECT_NE(narrow.header.find("/* range (+-90 deg/s) */"), std::string::npos);
  ASSERT_EQ(narrow.notes.size(), 1U);
  EXPECT_NE(narrow.notes[0].find("give --max-acceleration"), std::string::npos);
}

TEST_F(UseCases, FitCompareDiagnoseAndAddWithoutACommandLine) {
  const std::string file = static_model();
  CompareRequest comparison;
  comparison.models = {file};
  comparison.runs = {path("run.csv"), path("second.csv")};
  const std::vector<compare::ModelOnRuns> judged = compare(comparison);
  ASSERT_EQ(judged.size(), 1U);
  ASSERT_EQ(judged[0].runs.size(), 2U);

  DiagnoseRequest question;
  question.model = file;
  question.runs = {path("run.csv")};
  const DiagnoseOutcome answer = diagnose(question);
  EXPECT_EQ(answer.runs, question.runs);
  EXPECT_NE(answer.ladder.first.verdict, diagnosis::Verdict::none);
  ASSERT_TRUE(answer.ladder.next.addition);
  EXPECT_EQ(answer.ladder.next.addition->request.effects,
            std::vector<std::string>{"temperature_rate"});

  AddRequest addition;
  addition.model = file;
  addition.effects = answer.ladder.next.addition->request.effects;
  addition.runs = question.runs;
  addition.hold_outs = {path("second.csv")};
  const fit::Addition added = add(addition);
  EXPECT_TRUE(added.accepted) << added.reason;
  model::save_model(added.model, path("better.model"));

  comparison.models.push_back(path("better.model"));
  const std::vector<compare::ModelOnRuns> both = compare(comparison);
  EXPECT_LT(both[1].runs[1].comparison.whole.rms_dph, both[0].runs[1].comparison.whole.rms_dph);
}

TEST_F(UseCases, ExportWhatReplayThenRuns) {
  const std::string file = static_model();
  const ExportOutcome exported = export_header({file, {0.1, fog::OutputSelection::kvh, false}});
  EXPECT_LE(exported.quantization.worst_dph, board::kQuantizationLimitDph);
  std::ofstream(path("fog_model.h")) << exported.header;

  const auto bytes_of = [&](const std::string& weights) {
    ReplayRequest request;
    request.weights = weights;
    request.run = path("run.csv");
    std::vector<std::uint8_t> bytes;
    const board::ReplaySummary seen = replay(request, [&](fog::Span<const std::uint8_t> piece) {
      bytes.insert(bytes.end(), piece.data, piece.data + piece.size);
    });
    EXPECT_EQ(seen.output_bytes, bytes.size());
    return bytes;
  };
  const std::vector<std::uint8_t> from_model = bytes_of(file);
  EXPECT_FALSE(from_model.empty());
  EXPECT_EQ(from_model, bytes_of(path("fog_model.h")));
}

// Rows of a series as a user gets them.
struct AppliedSeries {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  std::vector<fog::Status> flags;

  SeriesSink sink() {
    return {[this](const std::vector<SeriesSink::Column>& all) {
              for (const SeriesSink::Column& each : all) columns.push_back(each.name);
            },
            [this](const std::vector<double>& values, fog::Status status) {
              rows.push_back(values);
              flags.push_back(status);
            }};
  }
  std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                    columns.begin());
  }
};

TEST_F(UseCases, ApplyGivesTheSeriesWhoseMeansCompareHas) {
  ApplyRequest request;
  request.weights = static_model();
  request.run = path("run.csv");
  AppliedSeries series;
  const ApplyOutcome outcome = apply(request, series.sink());
  EXPECT_EQ(outcome.rows, 5955U);
  EXPECT_EQ(series.columns,
            (std::vector<std::string>{"time_s", "temperature_degc", "rate_dph", "drift_bias_dph",
                                      "drift_bias_temperature_dph", "drift_dph", "compensated_dph",
                                      "sigma_dph"}));
  double square = 0;
  double mean = 0;
  for (const std::vector<double>& row : series.rows) {
    EXPECT_DOUBLE_EQ(row[3] + row[4], row[5]);
    EXPECT_DOUBLE_EQ(row[2] - row[5], row[6]);
    mean += row[6] / 5955;
    square += row[6] * row[6] / 5955;
  }
  CompareRequest judged;
  judged.models = {static_model()};
  judged.runs = {path("run.csv")};
  judged.average_s = 10;  // a row of the recording
  const compare::Comparison comparison = compare(judged)[0].runs[0].comparison;
  EXPECT_NEAR(std::sqrt(square), comparison.whole.rms_dph, 0.03 * comparison.whole.rms_dph);
  EXPECT_NEAR(outcome.compensated_std_dph, std::sqrt(square - mean * mean), 1e-4);
}

// A table that starts and stops within a block: the board compensates each sample by its own rate.
TEST_F(UseCases, ApplyFollowsTheInputRateFromSampleToSample) {
  model::Model gyro = fog::test::paper_like_model();
  gyro.network = {};
  gyro.terms = {fog::test::natural_term("scale_factor", {}, {1000})};
  gyro.terms[0].coefficients_dph[0].sigma = 0;
  model::save_model(gyro, path("table.model"));
  std::ofstream table(path("table.csv"));
  table << "time_s,temperature_degc,rate_dph,input_rate_dph\n";
  for (int row = 0; row < 400; ++row) {
    const double rate_dph = row / 30 % 2 == 0 ? 0 : 3600.0 * (row % 30);
    table << format("%.1f,20,%.3f,%.3f\n", 0.1 * row, 1.001 * rate_dph + 0.01 * (row % 3),
                    rate_dph);
  }
  table.close();
  ApplyRequest request;
  request.weights = path("table.model");
  request.run = path("table.csv");
  AppliedSeries series;
  apply(request, series.sink());
  ASSERT_EQ(series.rows.size(), 400U);
  for (const std::vector<double>& row : series.rows) {
    EXPECT_NEAR(row[series.place("compensated_dph")], row[series.place("input_rate_dph")], 0.03);
  }
}

// The second file does not begin at power-on: its lags go on from the first.
TEST_F(UseCases, CompareTakesFilesOfOneRunAsOne) {
  CompareRequest judged;
  judged.models = {static_model()};
  judged.runs = {path("run.csv")};
  const double whole_dph = compare(judged)[0].runs[0].comparison.whole.rms_dph;
  std::ifstream whole(path("run.csv"));
  std::ofstream first(path("first_half.csv"));
  std::ofstream second(path("second_half.csv"));
  std::string line;
  for (int rows = 0; std::getline(whole, line);) {
    const bool is_row = std::isdigit(static_cast<unsigned char>(line[0])) != 0;
    rows += is_row ? 1 : 0;
    if (!is_row || rows <= 3000) first << line << '\n';
    if (!is_row || rows > 3000) second << line << '\n';
  }
  first.close();
  second.close();
  judged.runs = {path("second_half.csv"), path("first_half.csv")};
  const std::vector<compare::ModelOnRun> runs = compare(judged)[0].runs;
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].comparison.whole.rms_dph, whole_dph, 1e-6 * whole_dph);
}

TEST_F(UseCases, ApplyOnTheBoardHasTheIntegersOfReplay) {
  ApplyRequest request;
  request.weights = static_model();
  request.run = path("run.csv");
  request.on_board = true;
  AppliedSeries series;
  apply(request, series.sink());
  request.board.output = fog::OutputSelection::compact;
  std::vector<std::uint8_t> bytes;
  replay(request, [&](fog::Span<const std::uint8_t> piece) {
    bytes.insert(bytes.end(), piece.data, piece.data + piece.size);
  });
  ASSERT_EQ(bytes.size(), series.rows.size() * fog::kCompactFrameBytes);
  const auto integer = [&](std::size_t row, const char* column) {
    return std::ldexp(series.rows[row][series.place(column)], fog::Rate::fractional_bits);
  };
  for (std::size_t row = 0; row < series.rows.size(); ++row) {
    fog::OutputSample sample;
    std::uint16_t delay = 0;
    ASSERT_TRUE(fog::decode_compact_frame(&bytes[row * fog::kCompactFrameBytes], sample, delay));
    EXPECT_EQ(integer(row, "compensated_dph"), sample.compensated.raw());
    EXPECT_EQ(integer(row, "drift_dph"), sample.drift.raw());
    EXPECT_EQ(integer(row, "denoised_dph"), sample.denoised.raw());
    EXPECT_EQ(series.flags[row], sample.status);
  }
}

// A flight's own record can be compared and diagnosed.
TEST_F(UseCases, ReadWhatABoardHasSentAsARecording) {
  ReplayRequest request;
  request.weights = static_model();
  request.run = path("run.csv");
  const recording::Recording given = recording::read_recording(request.run, {});
  for (const auto output :
       {fog::OutputSelection::compact, fog::OutputSelection::both, fog::OutputSelection::kvh}) {
    request.board.output = output;
    std::string bytes = "lost";  // the record begins amid a frame
    replay(request, [&](fog::Span<const std::uint8_t> piece) {
      bytes.append(reinterpret_cast<const char*>(piece.data), piece.size);
    });
    recording::ReadOptions options;
    options.stream_rate_hz = 0.1;
    std::string said;
    options.watch.remark = [&](const std::string& line) { said += line + "\n"; };
    const recording::Recording read =
        recording::read_recording(recording::temporary_file("flight.bin", bytes), options);
    const bool kvh = output == fog::OutputSelection::kvh;
    EXPECT_NE(said.find(kvh ? "compensated already" : "its drift put back"), std::string::npos)
        << said;
    ASSERT_GT(read.rows(), kvh ? 5400U : 5900U);            // until the denoiser is full
    const std::size_t behind = given.rows() - read.rows();  // the first ones are not valid
    EXPECT_NEAR(read.time_s.back(), given.time_s.back(), 1e-6);
    for (std::size_t row = 0; row < read.rows(); ++row) {
      EXPECT_NEAR(read.temperature_degc[row], given.temperature_degc[row + behind],
                  kvh ? 0.5001 : 1e-4);
      if (!kvh) {
        EXPECT_NEAR(read.rate_dph[row], given.rate_dph[row + behind], 1.01 / 1024);
      }
    }
  }
}

TEST_F(UseCases, ConvertGivesAllRowsOfAnyLayout) {
  const std::string file = recording::temporary_file(
      "lab.txt",
      "Time [ms];T [K];Gyro [deg/s]\n0;293,15;0,001\n500;600;0,002\n1000;293,15;0,003\n");
  const recording::Recording found = convert({file, {}});
  EXPECT_EQ(found.time_s, (std::vector<double>{0, 0.5, 1}));
  EXPECT_NEAR(found.temperature_degc[1], 326.85, 1e-9);  // whoever reads it judges it
  EXPECT_NEAR(found.rate_dph[2], 10.8, 1e-9);
}

// What a laboratory's files need is said once, when the first model is fitted.
TEST_F(UseCases, AModelRemembersWhichColumnIsWhich) {
  const recording::Recording run = recording::read_recording(path("run.csv"), {});
  std::string text = "Stamp;Temp;G1;G2\n";
  for (std::size_t row = 0; row < run.rows(); ++row) {
    text += format("%.0f;%.6f;%.10f;0\n", 1000 * run.time_s[row], run.temperature_degc[row],
                   run.rate_dph[row] / 3600);
  }
  FitRequest request = static_fit();
  request.runs = {recording::temporary_file("lab.txt", text)};
  EXPECT_THROW(fit(request), InputError);
  request.reading.columns = "time=Stamp[ms],rate=G1[deg/s]";
  model::save_model(fit(request).model, path("lab.model"));
  EXPECT_EQ(model::load_model(path("lab.model")).columns, request.reading.columns);
  CompareRequest judged;
  judged.models = {path("lab.model")};
  judged.runs = {path("lab.txt"), path("second.csv")};
  EXPECT_EQ(compare(judged)[0].runs.size(), 2U);
}

TEST_F(UseCases, DescribeAndDenoiseARecording) {
  const InfoOutcome described = info({path("run.csv"), {}, {}});
  EXPECT_EQ(described.recording.rows(), 5955U);
  EXPECT_FALSE(described.summary.segments.empty());
  const DenoiseOutcome denoised = denoise({path("run.csv"), {}, {}});
  ASSERT_FALSE(denoised.segments.empty());
  for (const DenoiseOutcome::SegmentBias& segment : denoised.segments) {
    EXPECT_LT(segment.denoised.std_dph, segment.raw.std_dph) << segment.name;
  }
}

TEST_F(UseCases, CalibrateAGyroAndNameItsFigures) {
  CalibrationRequest request;
  request.fit = static_fit();
  request.hold_outs = {path("second.csv")};
  request.board.sample_rate_hz = 0.1;
  request.model_file = path("gyro.model");
  bool fitted = false;
  bool judged = false;
  const CalibrationOutcome outcome = calibrate(
      request, {[&](const model::Model&) { fitted = true; },
                [&](const compare::ModelOnRuns& runs) { judged = runs.runs.size() == 1; }});
  EXPECT_TRUE(fitted && judged);
  const std::vector<std::string> known = figure_names(check(request.fit));
  for (const auto& [name, value] : outcome.figures) {
    EXPECT_NE(std::find(known.begin(), known.end(), name), known.end()) << name;
  }
}

TEST_F(UseCases, SayWhatIsWrongAsAnInputError) {
  FitRequest request = static_fit();
  request.runs = {path("no.csv")};
  EXPECT_THROW(fit(request), InputError);
  request = static_fit();
  request.effects = "bias,nothing";
  EXPECT_THROW(check(request), InputError);
  request = static_fit();
  request.preset = "polynomial";  // has effects of its own
  EXPECT_THROW(check(request), InputError);
  request.effects.reset();
  EXPECT_NO_THROW(check(request));
  request.preset = "ls-svm";  // no board carries it
  EXPECT_THROW(check(request), InputError);
  EXPECT_THROW(compare({{path("run.csv")}, {path("run.csv")}, {}, {}, false}), InputError);
  EXPECT_THROW(study_models("nothing"), InputError);
}

TEST_F(UseCases, TellTheirObserverOnceWhatWasLeftOut) {
  FitRequest request = static_fit();
  request.runs.push_back(request.runs[0]);
  std::vector<std::string> notes;
  Observer observer;
  observer.note = [&](const std::string& note) { notes.push_back(note); };
  fit(request, observer);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("run.csv"), std::string::npos) << notes[0];
}

TEST_F(UseCases, PrintNothing) {
  std::ofstream(path("odd.csv")) << "time_s,temperature_degc,rate_dph,mood\n0,85,1,2\n1,20,1,2\n"
                                    "2,20,1,2\n3,20,1,2\n";
  std::vector<std::string> remarks;
  Observer observer;
  observer.remark = [&](const std::string& remark) { remarks.push_back(remark); };
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  info({path("odd.csv"), {}, {}}, observer);
  info({path("odd.csv"), {}, {}});
  fit(static_fit());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0], path("odd.csv") + ": column ignored: mood");
}

TEST_F(UseCases, DiagnoseInOtherRows_ReadsNothingAgain) {
  const std::string file = path("once.csv");
  std::filesystem::copy_file(path("run.csv"), file);
  DiagnoseRequest question;
  question.model = static_model();  // in rows of 30 s
  question.runs = {file};
  const runs::Runs runs = judging_runs(question, {}, {});
  std::filesystem::remove(file);
  const diagnosis::Diagnosis found = diagnose(question, runs).ladder.first;
  EXPECT_EQ(found.row_s, 10);
  EXPECT_NEAR(found.noise_floor_dph, *runs.noise_floor_dph(10), 1e-12);
  EXPECT_NE(found.verdict, diagnosis::Verdict::none);
}

TEST_F(UseCases, EndWhenTheirObserverSaysSo) {
  Observer observer;
  observer.progress = [](const std::string&, double) { return false; };
  EXPECT_THROW(fit(static_fit(), observer), Cancelled);
  DiagnoseRequest question;
  question.model = static_model();
  question.runs = {path("run.csv")};
  EXPECT_THROW(diagnose(question, observer), Cancelled);
  AddRequest addition;
  addition.model = question.model;
  addition.effects = {"temperature_rate"};
  addition.runs = question.runs;
  EXPECT_THROW(add(addition, observer), Cancelled);
  EXPECT_THROW(compare({{question.model}, question.runs, {}, {}, false}, observer), Cancelled);
  EXPECT_THROW(SimulatedChamber(SimulateRequest()).run([](const auto&) {}, observer), Cancelled);
}

TEST_F(UseCases, KeepTheNetworkAsFarAsItIsTrained) {
  FitRequest request = static_fit();
  request.hidden = 2;
  request.average_s = 120;
  request.force_network = true;
  Observer observer;
  int calls = 0;
  observer.progress = [&](const std::string& stage, double) {
    return stage != kTraining || ++calls < 3;
  };
  const FitOutcome outcome = fit(request, observer);
  ASSERT_TRUE(outcome.result.training);
  EXPECT_TRUE(outcome.result.training->interrupted);
  EXPECT_TRUE(outcome.model.network.present());
}

}  // namespace
}  // namespace fogcomp::workflow
