// Complement of sensor_faults_test.cpp: a healthy gyro in a chamber raises no alarm.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "board/board_table.hpp"
#include "core/acquisition/calibration.hpp"
#include "core/acquisition/sample_monitor.hpp"
#include "support/sample_models.hpp"
#include "unit/simulation/run_helper.hpp"

namespace {

using fog::SensorSample;
using fog::Status;

struct Alarms {
  std::uint64_t samples = 0;
  std::uint64_t sensor_faults = 0;  ///< flags that only a fault may set
};

Alarms alarms_of_a_paper_run(double rate_hz, const std::string& sensor) {
  namespace simulation = fogcomp::simulation;
  simulation::GyroDescription gyro = simulation::gyro_of({}, "paper");
  gyro.apply_option("test", sensor);
  const simulation::Programme programme = simulation::profile_of("paper");
  simulation::SimulationOptions options;
  options.rate_hz = rate_hz;
  simulation::Simulation run(gyro, programme, options);
  const fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(fog::test::paper_like_model(), {rate_hz});
  const fog::ModelParameters parameters = fogcomp::board::read_board_table(table, "test");
  fog::SampleMonitor monitor(parameters.acquisition);
  constexpr Status kFaults = Status::gyro_stuck | Status::rate_out_of_range | Status::rate_jump |
                             Status::sequence_gap | Status::temperature_invalid;
  Alarms alarms;
  simulation::RowChunk chunk;
  std::uint16_t sequence = 0;
  while (run.next(chunk)) {
    for (std::size_t i = 0; i < chunk.rows(); ++i) {
      SensorSample sample;
      sample.sequence = sequence++;
      sample.rate_counts = static_cast<std::int32_t>(std::lround(chunk.rate_dph[i] * 1024));
      sample.temperature_q16 =
          static_cast<std::int32_t>(std::lround(chunk.temperature_degc[i] * 65536));
      sample.gyro_valid = sample.temperature_valid = true;
      const auto verdict =
          monitor.judge(sample, fog::calibrated_rate(parameters.calibration, sample.rate_counts));
      ++alarms.samples;
      alarms.sensor_faults += has_any(verdict.status, kFaults);
    }
  }
  return alarms;
}

TEST(NoFalseAlarm, InA16HourRunAt200Hz) {
  const Alarms alarms = alarms_of_a_paper_run(200, "sensor");
  std::printf("16.5 h at 200 Hz: %llu samples, %llu false alarms\n",
              static_cast<unsigned long long>(alarms.samples),
              static_cast<unsigned long long>(alarms.sensor_faults));
  EXPECT_GT(alarms.samples, 11'900'000U);
  EXPECT_EQ(alarms.sensor_faults, 0U);
}

TEST(NoFalseAlarm, WithCoarseAndFineAndNoiselessTemperatureSensors) {
  for (const char* sensor :
       {"sensor:resolution_k=1", "sensor:resolution_k=0.5", "sensor:resolution_k=0.0625,noise_k=0",
        "sensor:resolution_k=1,noise_k=0", "sensor:resolution_k=0.01,noise_k=0",
        "sensor:resolution_k=0.01", "sensor:resolution_k=0,noise_k=0.005",
        "sensor:resolution_k=0.0625,noise_k=0,at=chamber,lag_s=1",
        "sensor:resolution_k=0.0625,at=housing"}) {
    const Alarms alarms = alarms_of_a_paper_run(5, sensor);
    std::printf("16.5 h at 5 Hz, %-55s %llu false alarms\n", sensor,
                static_cast<unsigned long long>(alarms.sensor_faults));
    EXPECT_EQ(alarms.sensor_faults, 0U) << sensor;
  }
}

}  // namespace
