#include "recording/row_filter.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "unit/recording/heard_in.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp::recording {
namespace {

// 600 rows of as many sensors in turn, `apart` from each other in rate, in a column of that name.
std::string file_of(const char* column, int sensors, double apart, bool same_time = false) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise;
  std::string text = std::string("time_s,") + column + ",temperature_degc,rate_dph\n";
  for (int row = 0; row < 600; ++row) {
    const int sensor = row % sensors;
    const double time_s = same_time ? row / sensors : row / static_cast<double>(sensors);
    text += format("%.4f,%d,20,%.3f\n", time_s, sensor, apart * sensor + noise(random));
  }
  return text;
}

std::string refused(const std::string& content, const std::string& where = "") {
  ReadOptions options;
  options.where = where;
  try {
    read_recording(temporary_file("sensors.csv", content), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RowFilter, SensorsInTurn_RefusedWithTheChoice) {
  EXPECT_NE(refused(file_of("SensorId", 3, 0))
                .find("sensors.csv: rows of several sensors: column 2 'SensorId' is 0, 1, 2 in "
                      "turn; say which: --where SensorId=0 (or 'SensorId=*' if all rows are of "
                      "one)"),
            std::string::npos)
      << refused(file_of("SensorId", 3, 0));
  EXPECT_NE(refused(file_of("I", 2, 0, true)), "");
  EXPECT_NE(refused(file_of("k", 2, 5)), "");  // by what they measure
}

TEST(RowMarks, FlagOfTwoValues_Said) {
  std::string text = "time_s,temperature_degc,rate_dph,status\n";
  for (int row = 0; row < 50; ++row) text += format("%d,20,1,%s\n", row, row == 7 ? "BAD" : "OK");
  std::string said;
  read_recording(temporary_file("flag.csv", text), heard_in(said));
  EXPECT_NE(said.find("column 4 'status' is 'BAD' in 1 row and 'OK' in 49 rows, and all are read; "
                      "those of one value: --where status=OK"),
            std::string::npos)
      << said;
}

TEST(RowFilter, OtherColumns_NotTakenForSensors) {
  EXPECT_EQ(refused(file_of("parity", 2, 0)), "");
  EXPECT_EQ(refused(file_of("sensor_count", 600, 0)), "");
  EXPECT_EQ(refused(file_of("sensor", 1, 0)), "");
}

TEST(RowFilter, OneSensor_ItsRowsAlone) {
  std::string said;
  ReadOptions options = heard_in(said);
  options.where = "SensorId=1";
  const std::string path = temporary_file("sensors.csv", file_of("SensorId", 3, 100, true));
  const Recording one = read_recording(path, options);
  EXPECT_EQ(one.rows(), 200U);
  EXPECT_EQ(one.period_s, 1);
  for (const double rate : one.rate_dph) EXPECT_NEAR(rate, 100, 6);
  EXPECT_NE(said.find("sensors.csv: 400 rows of other sensors left out"), std::string::npos)
      << said;
  options.where = "2=1.0";
  EXPECT_EQ(read_recording(path, options).rows(), 200U);
  options.where = "SensorId=*";
  EXPECT_EQ(read_recording(temporary_file("one.csv", file_of("SensorId", 3, 100)), options).rows(),
            600U);
}

TEST(RowFilter, WrongChoice_Refused) {
  const std::string content = file_of("SensorId", 3, 0);
  EXPECT_NE(refused(content, "Sensor_Id=1").find("no column 'Sensor_Id', which --where names"),
            std::string::npos);
  EXPECT_NE(refused(content, "SensorId=7").find("has a header but no samples"), std::string::npos)
      << refused(content, "SensorId=7");
  for (const char* wrong : {"SensorId", "=1", "SensorId="}) {
    EXPECT_THROW(parse_row_choice(wrong), InputError) << wrong;
  }
}

TEST(MissingColumns, GivenByOptions_Read) {
  ReadOptions options;
  options.temperature_degc = 25;
  options.stream_rate_hz = 100;
  const Recording recording = read_recording(
      temporary_file("bare.csv", "gx [deg/h],ax [g]\n1,0\n2,0\n3,0\n4,0\n"), options);
  EXPECT_EQ(recording.period_s, 0.01);
  EXPECT_EQ(recording.temperature_degc, std::vector<double>(4, 25));
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{1, 2, 3, 4}));
  std::string said;
  ReadOptions needless = heard_in(said);
  needless.temperature_degc = 25;
  needless.stream_rate_hz = 100;
  read_recording(temporary_file("full.csv", "time_s,temperature_degc,rate_dph\n0,20,1\n1,20,2\n"),
                 needless);
  EXPECT_NE(said.find("its own temperatures are used; --temperature has no effect"),
            std::string::npos);
  EXPECT_NE(said.find("a CSV has its own times; --rate only helps where they are those of arrival"),
            std::string::npos);
}

TEST(MissingColumns, SampleCounter_TimesByTheRate) {
  const std::string path = temporary_file(
      "counter.csv", "n [samples],temperature_degc,rate_dph\n7,20,1\n8,20,2\n10,20,3\n11,20,4\n");
  ReadOptions options;
  options.columns = "time=n";
  EXPECT_THROW(read_recording(path, options), InputError);
  options.stream_rate_hz = 4;
  const Recording recording = read_recording(path, options);
  EXPECT_EQ(recording.time_s, (std::vector<double>{1.75, 2, 2.5, 2.75}));
  EXPECT_EQ(recording.stretch_starts.size(), 2U);
}

}  // namespace
}  // namespace fogcomp::recording
