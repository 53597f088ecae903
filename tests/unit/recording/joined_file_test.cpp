// A recording whose temperatures are in another file.
#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <string>

#include "heard_in.hpp"
#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

constexpr int kRateRows = 400;

// A rate each 0.1 s; times in `pattern`.
std::string rate_file(const char* time_name, double first, int decimals) {
  std::string text = std::string(time_name) + ",rate_dph\n";
  for (int row = 0; row < kRateRows; ++row) {
    text += format("%.*f,%d\n", decimals, first + 0.1 * row, row % 7);
  }
  return text;
}

// A temperature each 2 s, from 5 s before the rates to 5 s after them.
std::string temperature_file(const char* names, double first, double per_second, int decimals) {
  std::string text = std::string(names) + "\n";
  for (double time_s = -5; time_s < 0.1 * kRateRows + 5; time_s += 2) {
    text += format("%.*f,%.3f,55\n", decimals, (first + time_s) * per_second, 20 + time_s / 10);
  }
  return text;
}

Recording read_joined(const std::string& main, const std::string& inputs, std::string& said,
                      const std::string& columns = "") {
  ReadOptions options = heard_in(said);
  options.join = temporary_file("inputs.csv", inputs);
  options.join_columns = columns;
  return read_recording(temporary_file("main.csv", main), options);
}

void expect_joined(const Recording& recording, const std::string& what) {
  ASSERT_EQ(recording.rows(), static_cast<std::size_t>(kRateRows)) << what;
  EXPECT_NEAR(recording.temperature_degc[0], 19.9, 1e-6) << what;  // of a second before it
  for (std::size_t row = 10; row <= 390; ++row) {
    EXPECT_NEAR(recording.temperature_degc[row], 20 + 0.01 * static_cast<double>(row), 1e-4)
        << what << row;
  }
  EXPECT_NEAR(recording.temperature_degc[399], 23.9, 1e-6) << what;
}

TEST(JoinedFile, TemperaturesOfTheSameTimes_Taken) {
  std::string said;
  const std::string main = rate_file("time_s", 0, 1);
  expect_joined(read_joined(main, temperature_file("time_ms,temp_degC,x", 0, 1e3, 0), said),
                "power-on");
  EXPECT_NE(said.find("main.csv: joined with "), std::string::npos) << said;
  EXPECT_NE(said.find(": temperature_degc\n"), std::string::npos) << said;
  expect_joined(read_joined(main, temperature_file("time_s,A [degC],B [degC]", 0, 1, 1), said,
                            "temperature=A"),
                "mapped");
  const double unix_s = 1709625600;
  expect_joined(read_joined(rate_file("unix_s", unix_s, 1),
                            temperature_file("timestamp_ms,temp_degC,x", unix_s, 1e3, 0), said),
                "dates");
}

std::string join_refusal(const std::string& main, const std::string& inputs) {
  std::string said;
  try {
    read_joined(main, inputs, said);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(JoinedFile, OfOtherTimesOrColumns_Refused) {
  const std::string main = rate_file("time_s", 0, 1);
  const auto said = [&](const std::string& inputs) { return join_refusal(main, inputs); };
  EXPECT_NE(
      said(temperature_file("time_s,temp_degC,x", 5000, 1, 1)).find("they have none in common"),
      std::string::npos);
  EXPECT_NE(said(temperature_file("unix_s,temp_degC,x", 1709625600, 1, 1))
                .find("give both the same clock"),
            std::string::npos);
  EXPECT_NE(said("time_s,pressure_pa\n0,1\n1,1\n").find("no column 'temperature_degc'"),
            std::string::npos);
  const std::string complete = "time_s,temperature_degc,rate_dph\n0,20,1\n1,20,2\n";
  EXPECT_NE(join_refusal(complete, temperature_file("time_s,temp_degC,x", 0, 1, 1))
                .find("has no column that "),
            std::string::npos);
}

}  // namespace
}  // namespace fogcomp::recording
