#include "recording/recording_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/frames/sensor_frame.hpp"
#include "recording/csv_fields.hpp"
#include "support/output_file.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

std::string printed(double value, int decimals) {
  char text[kLongestDecimal];
  return std::string(text, print_fixed(value, decimals, text));
}

TEST(FixedDecimal, RoundsAndDropsTrailingZeros) {
  EXPECT_EQ(printed(0, 6), "0");
  EXPECT_EQ(printed(-0.0, 6), "0");
  EXPECT_EQ(printed(-4e-7, 6), "0");
  EXPECT_EQ(printed(-6e-7, 6), "-0.000001");
  EXPECT_EQ(printed(59999.995, 6), "59999.995");
  EXPECT_EQ(printed(-40, 5), "-40");
  EXPECT_EQ(printed(20.0625, 5), "20.0625");
  EXPECT_EQ(printed(0.1, 0), "0");
  EXPECT_EQ(printed(999999.9999996, 6), "1000000");
}

TEST(FixedDecimal, PrintsWhatDoesNotFitInShortestForm) {
  EXPECT_EQ(printed(-1e300, 6), "-1e+300");
  EXPECT_EQ(printed(std::numeric_limits<double>::quiet_NaN(), 6), "nan");
}

TEST(FixedDecimal, StaysWithinHalfAUnitOfTheLastPlace) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1e5, 1e5);
  for (int i = 0; i < 100000; ++i) {
    const double value = uniform(random);
    EXPECT_NEAR(std::stod(printed(value, 5)), value, 0.5000001e-5);
  }
}

TEST(RecordingWriter, WritesColumnsInTheOrderAskedFor) {
  const std::string path = temporary_path("writer_order.csv");
  const std::vector<double> rate{0.5, -1.25};
  const std::vector<double> time{0.005, 0.01};
  RecordingWriter writer(path, RecordingFormat::csv, {Column::rate_dph, Column::time_s}, 0, 0);
  writer.append({rate.data(), time.data()}, 2);
  writer.commit();
  EXPECT_EQ(read_file(path), "rate_dph,time_s\n0.5,0.005\n-1.25,0.01\n");
}

TEST(RecordingWriter, TurnsTimeGapsIntoSequenceGaps) {
  const std::string path = temporary_path("writer_gap.bin");
  const std::vector<double> time{327.67, 327.68, 327.70};  // 200 Hz: numbers 65534, 65536, 65540
  const std::vector<double> temperature{-40, -40, 60};
  const std::vector<double> rate{1, -1, 5e6};  // the last beyond the counts' range
  RecordingWriter writer(path, RecordingFormat::sensor_stream,
                         {Column::time_s, Column::temperature_degc, Column::rate_dph},
                         kDefaultScaleFactor, 200);
  writer.append({time.data(), temperature.data(), rate.data()}, 3);
  writer.commit();

  const std::string bytes = read_file(path);
  ASSERT_EQ(bytes.size(), 3 * fog::kSensorFrameBytes);
  std::vector<fog::SensorSample> samples(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* frame = reinterpret_cast<const std::uint8_t*>(bytes.data());
    ASSERT_TRUE(fog::decode_sensor_frame(frame + i * fog::kSensorFrameBytes, samples[i]));
  }
  EXPECT_EQ(samples[0].sequence, 65534);
  EXPECT_EQ(samples[1].sequence, 0);
  EXPECT_EQ(samples[2].sequence, 4);
  EXPECT_EQ(samples[1].rate_counts, -1024);
  EXPECT_EQ(samples[0].temperature_q16, -40 * 65536);
  EXPECT_TRUE(samples[1].gyro_valid);
  EXPECT_FALSE(samples[2].gyro_valid);
  EXPECT_TRUE(samples[2].temperature_valid);
}

TEST(RecordingWriter, LeavesNothingWithoutCommit) {
  const std::string path = temporary_path("writer_uncommitted.csv");
  { RecordingWriter writer(path, RecordingFormat::csv, {Column::time_s}, 0, 0); }
  EXPECT_ANY_THROW(read_file(path));
}

}  // namespace
}  // namespace fogcomp::recording
