#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "core/frames/sensor_frame.hpp"
#include "recording/recording.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp {
namespace {

struct Outcome {
  int code;
  std::string output;
};

/// Runs `fogcomp info` with stderr joined to stdout.
Outcome info(const std::string& arguments) {
  const std::string command = FOGCOMP " info " + arguments + " 2>&1";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return {-1, ""};
  Outcome outcome{0, ""};
  std::array<char, 4096> chunk;
  for (std::size_t got = 0; (got = std::fread(chunk.data(), 1, chunk.size(), pipe)) > 0;) {
    outcome.output.append(chunk.data(), got);
  }
  outcome.code = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

std::string recording(const std::string& name) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int i = 0; i < 2000; ++i) {
    text +=
        std::to_string(i) + ",20," + std::to_string(8.05 + 0.001 * ((i * 7919) % 101 - 50)) + "\n";
  }
  return recording::temporary_file(name, text);
}

TEST(InfoCommand, PrintsOneJsonObjectWithEveryPromisedKey) {
  const Outcome outcome = info(recording("info.csv") + " --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output.front(), '{');
  EXPECT_EQ(outcome.output.find('\n'), outcome.output.size() - 1);
  for (const char* key : {"rows",
                          "period_s",
                          "mean_dph",
                          "std_dph",
                          "noise_floor_dph",
                          "segments",
                          "name",
                          "start_s",
                          "end_s",
                          "temperature_min_degc",
                          "temperature_max_degc",
                          "allan",
                          "tau_s",
                          "sigma_dph",
                          "one_sigma_dph",
                          "angle_random_walk_dprh",
                          "bias_instability_dph",
                          "rate_random_walk_dphrh",
                          "rate_ramp_dphh",
                          "quantization_deg"}) {
    EXPECT_NE(outcome.output.find("\"" + std::string(key) + "\":"), std::string::npos) << key;
  }
}

TEST(InfoCommand, TellsHowManyRowsTheBoardWouldRefuse) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(i) + (i % 30 == 20 ? ",85,1\n" : ",20,1\n");
  }
  const std::string run = recording::temporary_file("refused.csv", text);
  const std::string said = info(run).output;
  EXPECT_NE(said.find("3 samples left out: temperature 85 degC at line 22 (then 52, 82) is"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("\n  3 samples left out by the board's rules\n"), std::string::npos) << said;
  EXPECT_NE(info(run + " --json").output.find("\"refused_rows\":3"), std::string::npos);
}

TEST(InfoCommand, TellsWhatADamagedCaptureHeld) {
  std::string bytes;
  for (const int sequence : {0, 1, 2, 1, 3, 6, 7, 8, 9}) {
    const fog::SensorFrame frame = fog::encode_sensor_frame(
        {static_cast<std::uint16_t>(sequence), 700 + sequence, 20 * 65536, true, sequence != 7});
    bytes.append(reinterpret_cast<const char*>(frame.data()), frame.size());
  }
  bytes[5 * 16 + 6] = static_cast<char>(bytes[5 * 16 + 6] + 1);  // of number 6
  const std::string run = recording::temporary_file("capture.bin", bytes);
  EXPECT_NE(info(run).output.find("\n  damaged bytes 16, missing samples 3, late or repeated "
                                  "samples 1, held temperatures 1\n"),
            std::string::npos)
      << info(run).output;
  EXPECT_NE(info(run + " --json")
                .output.find(
                    "\"capture\":{\"discarded_bytes\":16,\"missing_samples\":3,\"late_samples\":1,"
                    "\"invalid_samples\":0,\"held_temperatures\":1}"),
            std::string::npos)
      << info(run + " --json").output;
}

TEST(InfoCommand, SubtractsTheEarthRateOfALatitude) {
  const std::string run = recording("earth.csv");
  EXPECT_NE(info(run + " --json").output.find("\"mean_dph\":8.0"), std::string::npos);
  // 15.041 sin 30 = 7.52 deg/h
  EXPECT_NE(info(run + " --json --latitude 30").output.find("\"mean_dph\":0.5"), std::string::npos);
  EXPECT_NE(info(run + " --json --latitude 30 --axis down").output.find("\"mean_dph\":15.5"),
            std::string::npos);
}

TEST(InfoCommand, EndsWithCodeTwoAndOneLineForBadInput) {
  for (const std::string& arguments :
       {std::string("/no/such/file"),
        recording::temporary_file("bad.csv", "time_s,rate_dph\n1,2\n"),
        recording("axis.csv") + " --axis up", recording("average.csv") + " --average 0"}) {
    const Outcome outcome = info(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.output.find('\n'), outcome.output.size() - 1) << outcome.output;
  }
}

TEST(InfoCommand, TakesMoreThanTwentyMillionRowsInMeans) {
  std::string content = "time_s,temperature_degc,rate_dph\n";
  content.reserve(recording::kMaxRows * 13);
  for (std::size_t i = 0; i <= recording::kMaxRows; ++i) {
    content += std::to_string(i) + ",2," + std::to_string(i % 7) + "\n";
  }
  const std::string run = recording::temporary_file("long.csv", content);
  const Outcome outcome = info(run + " --json");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("\"rows\":2500001,\"rows_per_row\":8,"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("\"mean_dph\":2.9999"), std::string::npos) << outcome.output;
}

TEST(InfoCommand, ReadsOneRow) {
  const std::string run =
      recording::temporary_file("one.csv", "time_s,temperature_degc,rate_dph\n0,20,0.5\n");
  EXPECT_EQ(info(run).code, 0);
  EXPECT_NE(info(run + " --json").output.find("\"std_dph\":null"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp
