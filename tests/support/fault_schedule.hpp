#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "support/drift_under_faults.hpp"
#include "support/faulty_line.hpp"

// Random schedules of faults: which there are, how long they last and what they draw is data.
namespace fog::test {

/// What is drawn of a fault. Durations and values are drawn such that each order of magnitude is as
/// likely as the others, but for values of which some are not positive: these are uniform.
struct FaultDraw {
  Fault::Kind kind;
  const char* name;
  double shortest_s;
  double longest_s;
  double lowest = 0;
  double highest = 0;
};

constexpr double kShortestS = 0.005;
constexpr double kLongestS = 800;
constexpr double kApartS = 1600;  // at most, of what is drawn one after the other

/// Every kind; a fault of one that is missing here is never drawn.
inline constexpr FaultDraw kFaultDraws[] = {
    {Fault::Kind::no_temperature, "temperature missing", kShortestS, kLongestS},
    {Fault::Kind::no_samples, "samples lost", kShortestS, kLongestS},
    {Fault::Kind::restart, "demodulator restarts at", kShortestS, kLongestS, 0, 65536},
    {Fault::Kind::restart_ahead, "demodulator restarts ahead by", 0.05, 2, 1, 65535},
    {Fault::Kind::wrong_temperature, "temperature of", kShortestS, kLongestS, -80, 140},
    {Fault::Kind::temperature_offset, "temperature off by", kShortestS, kLongestS, -30, 30},
    {Fault::Kind::frozen_temperature, "temperature frozen", kShortestS, kLongestS},
    {Fault::Kind::sample_period, "sample period", kShortestS, kLongestS, 1840, 13590},
    {Fault::Kind::repeated, "samples repeated", kShortestS, kLongestS},
    {Fault::Kind::swapped, "samples swapped", kShortestS, kLongestS},
    {Fault::Kind::sparse, "one sample of", kShortestS, kLongestS, 2, 1000},
    {Fault::Kind::leaps, "numbers leap by", 1, kLongestS, 1, 1000},
    {Fault::Kind::repeats_one, "one sample again and again", kShortestS, kLongestS},
    {Fault::Kind::gyro_invalid, "gyro invalid", kShortestS, kLongestS},
    {Fault::Kind::power_cycle, "power lost", 0.1, kLongestS},
    // The watchdog expires after 0.1 s; a start takes another 0.1 s.
    {Fault::Kind::board_restart, "board restarts", 0.05, 1},
    {Fault::Kind::pin_reset, "reset by the pin", kShortestS, kLongestS},
};
static_assert(sizeof kFaultDraws / sizeof kFaultDraws[0] == kFaultKinds);

inline const char* name_of(Fault::Kind kind) {
  for (const FaultDraw& draw : kFaultDraws) {
    if (draw.kind == kind) return draw.name;
  }
  return "?";
}

struct FaultSchedule {
  bool has_clock;  ///< the board's, from a crystal
  std::vector<Fault> faults;
};

/// Faults one after the other and upon each other, in intervals long enough for trusted rates
/// between them. The same for the same seed.
class FaultScheduler {
 public:
  explicit FaultScheduler(std::uint64_t seed) : random_(seed) {}

  FaultSchedule draw(double duration_s) {
    FaultSchedule schedule{chance(0.5), {}};
    has_clock_ = schedule.has_clock;
    if (chance(0.3)) schedule.faults.push_back(fault(0));
    for (double time_s = uniform(0, kApartS); time_s < duration_s; time_s += uniform(0, kApartS)) {
      do {
        schedule.faults.push_back(fault(time_s + uniform(0, 100)));
      } while (chance(0.4));  // with what else
    }
    return schedule;
  }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }

  Fault fault(double from_s) {
    const FaultDraw& draw = kFaultDraws[random_() % kFaultKinds];
    // Without a clock nobody can find it: not promised (firmware/DESIGN.md).
    if (draw.kind == Fault::Kind::sample_period && !has_clock_) return fault(from_s);
    const double lasts_s = logarithmic(draw.shortest_s, draw.longest_s);
    double value = draw.lowest > 0 ? logarithmic(draw.lowest, draw.highest)
                                   : uniform(draw.lowest, draw.highest);
    if (draw.kind == Fault::Kind::sparse) value = std::floor(value);
    return {draw.kind, from_s, from_s + lasts_s, value};
  }

  std::mt19937_64 random_;
  bool has_clock_ = true;
};

/// A board with a crystal and one without a clock, each for the schedules that are drawn for it.
class ScheduledBoards {
 public:
  explicit ScheduledBoards(const fogcomp::model::Model& model)
      : with_clock_(model, kMaxDegcPerMin, DriftUnderFaults::BoardClock::crystal),
        without_clock_(model, kMaxDegcPerMin, DriftUnderFaults::BoardClock::none) {}

  /// As DriftUnderFaults::run().
  DriftVerdict run(const FaultSchedule& schedule, double duration_s, std::uint64_t seed) const {
    const DriftUnderFaults& board = schedule.has_clock ? with_clock_ : without_clock_;
    return board.run(schedule.faults, duration_s, seed);
  }

 private:
  static constexpr double kMaxDegcPerMin = 3;

  DriftUnderFaults with_clock_;
  DriftUnderFaults without_clock_;
};

/// What is needed to run it again by itself.
inline void print(const FaultSchedule& schedule) {
  std::printf("  %s\n", schedule.has_clock ? "with a crystal" : "without a clock");
  for (const Fault& fault : schedule.faults) {
    std::printf("  %.3f to %.3f s: %s %g\n", fault.from_s, fault.to_s, name_of(fault.kind),
                fault.value);
  }
}

}  // namespace fog::test
