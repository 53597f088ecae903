#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/reading.hpp"
#include "unit/simulation/run_helper.hpp"

namespace fogcomp::simulation {
namespace {

recording::Recording recording_of(const std::string& profile, double rate_hz,
                                  const std::string& sensor) {
  SimulationOptions options = coarse();
  options.rate_hz = rate_hz;
  const WholeRun run = whole_run(gyro_of({sensor}, "paper"), profile_of(profile), options);
  recording::Recording recording;
  recording.period_s = 1 / rate_hz;
  recording.time_s = run.rows.time_s;
  recording.temperature_degc = run.rows.temperature_degc;
  recording.rate_dph = run.rows.rate_dph;
  return recording;
}

recording::Recording every(std::size_t step, const recording::Recording& recording) {
  recording::Recording thin;
  thin.period_s = recording.period_s * static_cast<double>(step);
  for (std::size_t row = 0; row < recording.rows(); row += step) {
    thin.time_s.push_back(recording.time_s[row]);
    thin.temperature_degc.push_back(recording.temperature_degc[row]);
    thin.rate_dph.push_back(recording.rate_dph[row]);
  }
  return thin;
}

// Data without faults are not refused: in rows of 10 and 60 s, and of 1 s.
TEST(RefusedRows, AreNoneInAnyReadyMadeProfile) {
  for (const EmbeddedFile& profile : ready_made_profiles()) {
    const std::string name(profile.name);
    for (const char* sensor : {"sensor", "sensor:resolution_k=1,noise_k=0,at=chamber"}) {
      const recording::Recording recording = recording_of(name, 0.1, sensor);
      EXPECT_TRUE(recording::refused_rows(recording, {}).empty()) << name << " " << sensor;
      EXPECT_TRUE(recording::refused_rows(every(6, recording), {}).empty())
          << name << " " << sensor;
    }
  }
  for (const char* name : {"random_steps", "power_cycles"}) {
    const recording::Recording recording = recording_of(name, 1, "sensor:resolution_k=1");
    EXPECT_TRUE(recording::refused_rows(recording, {}).empty()) << name;
    EXPECT_TRUE(recording::frozen_temperatures(recording).empty()) << name;
  }
}

}  // namespace
}  // namespace fogcomp::simulation
