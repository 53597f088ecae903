#include "planning/typical_gyro.hpp"

#include <array>

#include "simulation/gyro_description.hpp"
#include "simulation/simulation.hpp"
#include "support/text.hpp"

namespace fogcomp::planning {
namespace {

constexpr double kStep_s = 20;  // of heat flow: rows of a minute need no finer one

// One move of the day: where in the range of temperatures it ends, at which part of the fastest
// ramp, how long the soak is, and which part of the largest input rate acts meanwhile.
struct Move {
  double place;
  double ramp;
  double soak_min;
  double rate;
};
constexpr std::array<Move, 12> kDay{{{0, 1, 90, 1},
                                     {0.5, 0.5, 0, -1},
                                     {1, 1, 90, 0.5},
                                     {0.25, 0.75, 30, -0.5},
                                     {0.75, 1, 0, 0},
                                     {0, 0.5, 60, 0.75},
                                     {0.9, 0.75, 0, -0.25},
                                     {0.6, 1, 60, 0.25},
                                     {0.1, 1, 0, -0.75},
                                     {0.4, 0.5, 30, 1},
                                     {1, 0.75, 60, 0},
                                     {0.5, 1, 60, -1}}};

// A profile for simulation::parse_profile.
std::string day_in(const OperatingBox& box) {
  const auto [low, high] = box.temperature_degc;
  double now = (low + high) / 2;
  std::string profile = format("start %.6g degC\n", now);
  for (const Move& move : kDay) {
    const double target = low + move.place * (high - low);
    const double fastest = target > now ? box.ramp_degc_per_min.max : -box.ramp_degc_per_min.min;
    if (box.rate_dps > 0) profile += format("rate %.6g deg/s\n", move.rate * box.rate_dps);
    profile += format("ramp to %.6g degC at %.6g degC/min\n", target, move.ramp * fastest);
    if (move.soak_min > 0) profile += format("soak %.6g min\n", move.soak_min);
    now = target;
  }
  return profile;
}

}  // namespace

recording::Recording typical_recording(const simulation::Programme& programme,
                                       const std::string& name, double row_s) {
  simulation::GyroDescription gyro;
  gyro.set(name, "sensor", {"noise_k=0", "resolution_k=0"});
  simulation::SimulationOptions options;
  options.rate_hz = 1 / row_s;
  options.grid.axial_cells = 1;
  options.grid.step_s = kStep_s;
  simulation::Simulation run(gyro, programme, options);
  recording::Recording recording = simulation::record(run, row_s).recording;
  recording.file = name;
  recording.rate_dph.assign(recording.time_s.size(), 0);
  return recording;
}

recording::Recording typical_day(const OperatingBox& box, double row_s) {
  const char* const name = "a day in the box";
  return typical_recording(simulation::parse_profile(day_in(box), name, 1), name, row_s);
}

}  // namespace fogcomp::planning
