#include "clean_gyro.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/random.hpp"
#include "support/text.hpp"

namespace fogcomp::coverage {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRow_s = 10;  // the noise is stated per row of this length
constexpr double kHour_s = 3600;

struct Sensor {
  const char* name;
  double step_degc;
  double noise_degc;  // of a sample
};
constexpr std::array<Sensor, 4> kSensors{{{"0.004 degC", 0.004, 0.004},
                                          {"0.0625 degC", 0.0625, 0.03},
                                          {"0.25 degC", 0.25, 0.05},
                                          {"1 degC", 1, 0.05}}};

// Standard deviations relative to the white noise of a row.
struct Noise {
  const char* name;
  double flicker;  // Allan deviation's floor, 0.664 times the coefficient of 1/f
  double walk;     // at the end of a run
};
constexpr std::array<Noise, 4> kNoises{
    {{"white", 0, 0}, {"white, flicker", 0.25, 0}, {"white, walk", 0, 1}, {"all three", 0.25, 1}}};

// Uniform within a range.
double within(Random& draw, double min, double max) {
  return min + (max - min) * draw.uniform();
}

// Chamber temperatures as corners, straight in between; then two lags, of the chamber and of the
// housing, which the thermometer sits on.
struct Corner {
  double time_s;
  double degc;
};

std::vector<double> along(const std::vector<Corner>& corners, double step_s, double lag_s) {
  std::vector<double> degc;
  double first = corners.front().degc;
  double second = first;
  const double share = 1 - std::exp(-step_s / lag_s);
  std::size_t at = 0;
  for (double time_s = 0; time_s < corners.back().time_s; time_s += step_s) {
    while (at + 2 < corners.size() && corners[at + 1].time_s <= time_s) ++at;
    const double part =
        (time_s - corners[at].time_s) / (corners[at + 1].time_s - corners[at].time_s);
    const double set = corners[at].degc + part * (corners[at + 1].degc - corners[at].degc);
    first += share * (set - first);
    second += share * (first - second);
    degc.push_back(second);
  }
  return degc;
}

// Soaks with ramps in between.
std::vector<Corner> soaks(Random& draw, double cold, double warm) {
  std::vector<Corner> corners{{0, 20}};
  const double rate_per_s = within(draw, 0.3, 1) / 60;
  for (const double degc : {20.0, warm, 20.0, cold, 20.0}) {
    const double ramp_s = std::abs(degc - corners.back().degc) / rate_per_s;
    if (ramp_s > 0) corners.push_back({corners.back().time_s + ramp_s, degc});
    corners.push_back({corners.back().time_s + within(draw, 1, 2) * kHour_s, degc});
  }
  return corners;
}

// Up and down without a rest.
std::vector<Corner> cycles(Random& draw, double cold, double warm) {
  std::vector<Corner> corners{{0, cold}};
  const double half_s = within(draw, 0.4, 1.2) * kHour_s;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({corners.back().time_s + half_s, i % 2 == 0 ? warm : cold});
  }
  return corners;
}

// Fast cycles of twenty minutes, as for small gyros.
std::vector<Corner> fast_cycles(Random& draw, double cold, double warm) {
  std::vector<Corner> corners{{0, cold}};
  for (int i = 0; i < 24; ++i) {
    corners.push_back({corners.back().time_s + within(draw, 8, 12) * 60, i % 2 == 0 ? warm : cold});
  }
  return corners;
}

// Steps of the chamber, random in height.
std::vector<Corner> steps(Random& draw, double cold, double warm) {
  std::vector<Corner> corners{{0, 20}};
  for (int i = 0; i < 12; ++i) {
    const double degc = within(draw, cold, warm);
    corners.push_back({corners.back().time_s + 60, degc});
    corners.push_back({corners.back().time_s + within(draw, 0.5, 1.5) * kHour_s, degc});
  }
  return corners;
}

// Three days outdoors: day and night, and weather.
std::vector<Corner> days(Random& draw, double cold, double warm) {
  std::vector<Corner> corners;
  const double middle = (cold + warm) / 2;
  double weather = 0;
  for (double hour = 0; hour <= 72; hour += 0.5) {
    weather += 0.15 * (draw.gaussian() - 0.2 * weather);
    corners.push_back({hour * kHour_s, middle + (warm - cold) / 2 * 0.8 *
                                                    (std::sin(2 * kPi * hour / 24) + weather)});
  }
  return corners;
}

struct Way {
  const char* name;
  std::vector<Corner> (*corners)(Random&, double cold, double warm);
  double step_s;  // of a sample
  double lag_s;
};
constexpr std::array<Way, 5> kWays{{{"soaks and ramps", soaks, 1, 240},
                                    {"cycles of hours", cycles, 1, 240},
                                    {"cycles of 20 min", fast_cycles, 1, 60},
                                    {"chamber steps", steps, 1, 400},
                                    {"three days", days, 10, 900}}};

// A sum of Gauss-Markov processes an octave apart, whose spectra add up to 1/f.
class Flicker {
 public:
  Flicker(double floor_dph, double step_s, double run_s, Random& draw) : draw_(draw) {
    if (floor_dph == 0) return;
    // Octaves of equal variance v: density v / (ln 2) / f, and the floor is sqrt(2 ln 2 * density).
    const double deviation = floor_dph / std::sqrt(2.0);
    for (double tau_s = 2 * step_s; tau_s < 8 * run_s; tau_s *= 2) {
      const double phi = std::exp(-step_s / tau_s);
      parts_.push_back({phi, deviation * std::sqrt(1 - phi * phi), deviation * draw_.gaussian()});
    }
  }
  double next() {
    double sum = 0;
    for (Part& part : parts_) {
      sum += part.value;
      part.value = part.phi * part.value + part.drive * draw_.gaussian();
    }
    return sum;
  }

 private:
  struct Part {
    double phi;
    double drive;
    double value;
  };
  Random& draw_;
  std::vector<Part> parts_;
};

struct Gyro {
  double b0;
  double b1;
  double b2;
  double k;
  double white_dph;  // of a row
  double turn_on_dph;
};

recording::Recording run_of(const Gyro& gyro, const Sensor& sensor, const Noise& noise,
                            const Way& way, double cold, double warm, const std::string& name,
                            std::uint64_t seed) {
  Random programme(seed, "programme " + name);
  Random draw(seed, "noise " + name);
  Random thermometer(seed, "thermometer " + name);
  const std::vector<double> degc = along(way.corners(programme, cold, warm), way.step_s, way.lag_s);
  const double run_s = static_cast<double>(degc.size()) * way.step_s;
  const double white_dph = gyro.white_dph * std::sqrt(kRow_s / way.step_s);
  const double walk_dph = noise.walk * gyro.white_dph * std::sqrt(way.step_s / run_s);
  Flicker flicker(noise.flicker * gyro.white_dph, way.step_s, run_s, draw);
  const double bias_dph = gyro.b0 + gyro.turn_on_dph * draw.gaussian();
  double walk = 0;
  recording::Recording run;
  run.file = name;
  run.period_s = way.step_s;
  run.stretch_starts = {0};
  for (std::size_t i = 0; i < degc.size(); ++i) {
    const double before = degc[i == 0 ? 0 : i - 1];
    const double after = degc[std::min(i + 1, degc.size() - 1)];
    const double per_min = (after - before) / (2 * way.step_s) * 60;
    const double x = degc[i] - 20;
    const double drift = bias_dph + x * (gyro.b1 + x * gyro.b2) + gyro.k * per_min;
    walk += walk_dph * draw.gaussian();
    run.time_s.push_back(static_cast<double>(i) * way.step_s);
    run.rate_dph.push_back(drift + walk + flicker.next() + white_dph * draw.gaussian());
    const double seen = degc[i] + sensor.noise_degc * thermometer.gaussian();
    run.temperature_degc.push_back(sensor.step_degc * std::round(seen / sensor.step_degc));
  }
  return run;
}

template <class Table>
const auto& one_of(const Table& table, Random& draw) {
  return table[static_cast<std::size_t>(draw.uniform() * static_cast<double>(table.size()))];
}

}  // namespace

CleanGyro clean_gyro(std::uint64_t seed) {
  Random draw(seed, "gyro");
  const Sensor& sensor = one_of(kSensors, draw);
  const Noise& noise = one_of(kNoises, draw);
  const Way& way = one_of(kWays, draw);
  const Way& other = one_of(kWays, draw);
  const int power_ons = 1 + static_cast<int>(3 * draw.uniform());
  Gyro gyro{};
  gyro.white_dph = 0.005 * std::exp2(3 * draw.uniform());
  gyro.b0 = draw.gaussian();
  gyro.b1 = 4e-4 * draw.gaussian();
  gyro.b2 = 2e-5 * draw.gaussian();
  gyro.k = 0.12 * draw.gaussian();
  // One power-on tells nothing of others: the unseen run then has its bias.
  if (power_ons > 1) gyro.turn_on_dph = gyro.white_dph * within(draw, 0.2, 3);
  const double cold = within(draw, -40, 0);
  const double warm = within(draw, 40, 65);
  CleanGyro made{
      {sensor.name, noise.name, way.name, counted(static_cast<std::size_t>(power_ons), "power-on")},
      gyro.b1,
      gyro.b2,
      gyro.k,
      {},
      {}};
  for (int i = 0; i < power_ons; ++i) {
    made.training.push_back(
        run_of(gyro, sensor, noise, way, cold, warm, format("run %d", i + 1), seed));
  }
  made.unseen = run_of(gyro, sensor, noise, other, cold, warm, "unseen", seed);
  return made;
}

}  // namespace fogcomp::coverage
