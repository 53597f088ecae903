#include "recording/stream_reader.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/frames/sensor_frame.hpp"
#include "recording/columns.hpp"
#include "recording/recording_writer.hpp"
#include "support/input_error.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

std::string frame(std::size_t number, bool gyro_valid = true, bool temperature_valid = true) {
  fog::SensorSample sample;
  sample.sequence = static_cast<std::uint16_t>(number);
  sample.rate_counts = static_cast<std::int32_t>(number) * 1024;
  sample.temperature_q16 = static_cast<std::int32_t>(number % 100) * 65536;
  sample.gyro_valid = gyro_valid;
  sample.temperature_valid = temperature_valid;
  const fog::SensorFrame bytes = fog::encode_sensor_frame(sample);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Recording read_stream(const std::string& bytes, const ReadOptions& options = {}) {
  return read_recording(temporary_file("capture.csv", bytes), options);
}

TEST(StreamReader, GivesBackWhatTheWriterWrote) {
  const std::string path = temporary_path("round_trip.txt");
  std::vector<double> time;
  std::vector<double> temperature;
  std::vector<double> rate;
  for (int i = 0; i < 200000; ++i) {  // three wraps of the sequence, one gap of 10 s
    time.push_back((i + (i > 100000 ? 2000 : 0)) / 200.0);
    temperature.push_back(i / 65536.0);
    rate.push_back((i - 100000) / 1024.0);
  }
  RecordingWriter writer(path, RecordingFormat::sensor_stream,
                         {Column::time_s, Column::temperature_degc, Column::rate_dph},
                         kDefaultScaleFactor, 200);
  writer.append({time.data(), temperature.data(), rate.data()}, time.size());
  writer.commit();

  const Recording recording = read_recording(path, {});
  EXPECT_EQ(recording.time_s, time);
  EXPECT_EQ(recording.temperature_degc, temperature);
  EXPECT_EQ(recording.rate_dph, rate);
  EXPECT_EQ(recording.period_s, 0.005);
  EXPECT_EQ(recording.stretch_starts, (std::vector<std::size_t>{0, 100001}));
  ASSERT_TRUE(recording.capture.has_value());
  EXPECT_EQ(recording.capture->missing_samples, 2000U);
}

TEST(StreamReader, GivesBackTheInputsOfExtensionRecords) {
  const std::string path = temporary_path("extension.bin");
  std::vector<std::vector<double>> columns(8);
  for (int i = 0; i < 1000; ++i) {
    columns[0].push_back(i / 200.0);
    for (std::size_t c = 1; c < columns.size(); ++c) {
      columns[c].push_back(20 + static_cast<double>(c) * i / 65536.0);
    }
  }
  RecordingWriter writer(
      path, RecordingFormat::sensor_stream,
      {Column::time_s, Column::temperature_degc, Column::rate_dph, column_of(fog::Input::vibration),
       column_of(fog::Input::temperature2), column_of(fog::Input::magnetic),
       column_of(fog::Input::light_power), column_of(fog::Input::supply)},
      kDefaultScaleFactor, 200);
  std::vector<const double*> values;
  for (const auto& column : columns) values.push_back(column.data());
  writer.append(values, columns[0].size());
  writer.commit();

  const Recording recording = read_recording(path, {});
  EXPECT_EQ(recording[fog::Input::vibration], columns[3]);
  EXPECT_EQ(recording[fog::Input::temperature2], columns[4]);
  EXPECT_EQ(recording[fog::Input::magnetic], columns[5]);
  EXPECT_EQ(recording[fog::Input::light_power], columns[6]);
  EXPECT_EQ(recording[fog::Input::supply], columns[7]);
  EXPECT_EQ(recording.capture->discarded_bytes, 0U);
}

TEST(StreamReader, HoldsAnInputUntilItsNextRecord) {
  const auto record = [](std::int32_t degc) {
    const auto frame = fog::encode_extension_frame(
        {fog::Input::temperature2, fog::ExtensionValue::from_raw(degc * 65536)});
    return std::string(reinterpret_cast<const char*>(frame.data()), frame.size());
  };
  const Recording recording =
      read_stream(frame(1) + record(30) + frame(2) + frame(3) + record(-300) + record(131) +
                  frame(4) + record(31) + frame(5));
  EXPECT_EQ(recording[fog::Input::temperature2], (std::vector<double>{30, 30, 30, 30, 31}));
}

TEST(StreamReader, UsesScaleFactorAndSampleRate) {
  ReadOptions options;
  options.scale_factor = 3600;  // one count per deg/h
  options.stream_rate_hz = 10;
  const Recording recording = read_stream(frame(1) + frame(2), options);
  EXPECT_EQ(recording.time_s, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{1024, 2048}));
}

TEST(StreamReader, LeavesOutInvalidSamplesAndHoldsTheTemperature) {
  const Recording recording = read_stream(frame(0, true, false) + frame(1) + frame(2, false) +
                                          frame(3, true, false) + frame(3) + frame(4));
  EXPECT_EQ(recording.time_s, (std::vector<double>{0.005, 0.015, 0.02}));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{1, 2, 4}));
  EXPECT_EQ(recording.capture->invalid_samples, 2U);  // 0 has no temperature yet, 2 no rate
  EXPECT_EQ(recording.capture->held_temperatures, 1U);
  EXPECT_EQ(recording.capture->late_samples, 1U);
}

std::string stream_of(const std::vector<std::size_t>& sequence) {
  std::string bytes;
  for (const std::size_t number : sequence) {
    fog::SensorSample sample{static_cast<std::uint16_t>(number), 1024, 20 * 65536, true, true};
    const fog::SensorFrame frame = fog::encode_sensor_frame(sample);
    bytes.append(reinterpret_cast<const char*>(frame.data()), frame.size());
  }
  return bytes;
}

std::vector<std::size_t> numbers(std::size_t first, std::size_t end) {
  std::vector<std::size_t> sequence(end - first);
  std::iota(sequence.begin(), sequence.end(), first);
  return sequence;
}

// A late sample has no row; it does not mean 65,535 lost ones.
TEST(StreamReader, LetsTimeStandAtALateOrRepeatedSample) {
  std::vector<std::size_t> late = numbers(0, 60000);
  late.insert(late.begin() + 30000, 29998);
  std::vector<std::size_t> repeated = numbers(0, 60000);
  repeated.insert(repeated.begin() + 30000, 29999);
  for (const auto& sequence : {late, repeated}) {
    const Recording recording = read_stream(stream_of(sequence));
    EXPECT_EQ(recording.rows(), 60000U);
    EXPECT_EQ(recording.time_s.back(), 59999 / 200.0);
    EXPECT_EQ(recording.stretch_starts.size(), 1U);
    EXPECT_EQ(recording.capture->late_samples, 1U);
    EXPECT_EQ(recording.capture->missing_samples, 0U);
  }
  std::vector<std::size_t> swapped = numbers(0, 60000);
  std::swap(swapped[30000], swapped[30001]);
  const Recording recording = read_stream(stream_of(swapped));
  EXPECT_EQ(recording.rows(), 59999U);
  EXPECT_EQ(recording.time_s.back(), 59999 / 200.0);
  EXPECT_EQ(recording.capture->late_samples, 1U);
  EXPECT_EQ(recording.capture->missing_samples, 1U);
}

TEST(StreamReader, FollowsADemodulatorThatCountsAnewAsTheBoardDoes) {
  const Recording recording =
      read_stream(stream_of(numbers(0, 30000)) + stream_of(numbers(0, 10000)));
  EXPECT_EQ(recording.rows(), 39993U) << "seven are taken for late";
  EXPECT_EQ(recording.time_s.back(), 39999 / 200.0) << "but their time passed";
  EXPECT_EQ(recording.capture->late_samples, 7U);
  EXPECT_EQ(recording.capture->missing_samples, 7U);
}

TEST(StreamReader, HoldsTheTemperatureWhereItIsImpossible) {
  fog::SensorSample sample{2, 0, -300 * 65536, true, true};
  const fog::SensorFrame cold = fog::encode_sensor_frame(sample);
  const Recording recording =
      read_stream(frame(1) + std::string(reinterpret_cast<const char*>(cold.data()), cold.size()));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{1, 1}));
  EXPECT_EQ(recording.capture->held_temperatures, 1U);
}

// Without a temperature a board gives up its drift after a minute: then it has no valid rate.
TEST(StreamReader, HoldsATemperatureNoLongerThanTheBoardHoldsADrift) {
  ReadOptions options;
  options.stream_rate_hz = 1;
  std::string bytes = frame(1);
  for (std::size_t number = 2; number <= 100; ++number) bytes += frame(number, true, false);
  const Recording recording = read_stream(bytes + frame(101), options);
  EXPECT_EQ(recording.rows(), 62U);
  EXPECT_EQ(recording.time_s[60], 61);
  EXPECT_EQ(recording.time_s[61], 101);
  EXPECT_EQ(recording.capture->held_temperatures, 60U);
  EXPECT_EQ(recording.capture->invalid_samples, 39U);
}

TEST(StreamReader, LeavesOutSamplesWhoseTemperatureJumps) {
  std::string bytes = stream_of(numbers(0, 1000));
  fog::SensorSample sample{1000, 1024, 85 * 65536, true, true};
  for (int i = 0; i < 150; ++i, ++sample.sequence) {
    const fog::SensorFrame wrong = fog::encode_sensor_frame(sample);
    bytes.append(reinterpret_cast<const char*>(wrong.data()), wrong.size());
  }
  const Recording recording = read_stream(bytes + stream_of(numbers(1150, 2000)));
  EXPECT_EQ(recording.rows(), 1850U);
  EXPECT_EQ(recording.refused_rows, 150U);
  EXPECT_EQ(recording.time_s.back(), 1999 / 200.0);
  EXPECT_EQ(recording.capture->held_temperatures, 0U);
}

TEST(StreamReader, IsNotFooledByDamageAtTheStart) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    std::string bytes;
    for (std::size_t n = random() % 300; n > 0; --n) bytes += static_cast<char>(random());
    if (round % 2 == 0) bytes += "time_s,temperature_degc,rate_dph\n";
    bytes += frame(1).substr(random() % 16);
    const std::size_t damage = bytes.size();
    bytes += frame(7) + frame(8) + frame(9).substr(0, 5);
    const Recording recording = read_stream(bytes);
    ASSERT_GE(recording.rows(), 2U);
    EXPECT_LE(recording.capture->discarded_bytes, damage + 5);
    EXPECT_EQ(recording.rate_dph.back(), 8);
  }
}

TEST(StreamReader, RefusesWhatHoldsNoGoodFrame) {
  const auto refused = [](const std::string& bytes) {
    EXPECT_THROW(read_stream(bytes), InputError);
  };
  refused(frame(1).substr(0, 15));
  refused(std::string(1000, '\0'));
  refused(frame(1, false));
  refused(std::string("t\0i\0m\0e\0_\0s\0\n\0", 14));  // UTF-16
}

TEST(StreamReader, TakesACsvWithAStrayControlCharacterForACsv) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + ",20,1\n";
  text[60] = '\0';
  EXPECT_FALSE(is_sensor_stream(text));
}

}  // namespace
}  // namespace fogcomp::recording
