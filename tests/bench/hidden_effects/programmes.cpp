#include "programmes.hpp"

#include <algorithm>

#include "support/input_error.hpp"

namespace fogcomp::bench {
namespace {

constexpr std::size_t kMaxRows = 16'000;
constexpr double kOneRun = 0.35;
constexpr double kTwoRuns = 0.4;  // else three

const ProgrammeFacts& facts_of(const std::string& name) {
  for (const ProgrammeFacts& facts : programmes()) {
    if (facts.name == name) return facts;
  }
  throw InputError("programme '" + name + "'", "is not one of the benchmark's");
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

const std::vector<ProgrammeFacts>& programmes() {
  using Kind = ProgrammeFacts::Kind;
  static const std::vector<ProgrammeFacts> all{
      {"paper", 5955, -40, 60, 0, Kind::thermal},
      {"reversed", 5955, -40, 60, 0, Kind::thermal},
      {"random_steps", 3780, 10, 30, 0, Kind::thermal},
      {"minor_loops", 8640, -40, 60, 0, Kind::thermal},
      {"ramp_rates", 8040, -40, 60, 0, Kind::thermal},
      {"power_cycles", 5640, -20, 50, 0, Kind::thermal},
      {"axis_flips", 5820, -40, 60, 0, Kind::special},
      {"rate_table", 3660, -40, 60, 10, Kind::turning},
      {"rate_steps", 3120, -30, 60, 100, Kind::turning},
      {"rate_sweeps", 420, 10, 45, 100, Kind::turning},
      {"heater_pulses", 2880, 20, 30, 0, Kind::special},
      {"field_and_vibration", 2760, 20, 20, 0, Kind::special},
  };
  return all;
}

std::vector<std::string> draw_programmes(Draws& draws, const std::vector<std::string>& required) {
  std::vector<std::string> thermal;
  for (const ProgrammeFacts& facts : programmes()) {
    if (facts.kind == ProgrammeFacts::Kind::thermal) thermal.push_back(facts.name);
  }
  const double which = draws.uniform(0, 1);
  std::size_t wanted = 3;
  if (which < kOneRun + kTwoRuns) wanted = 2;
  if (which < kOneRun) wanted = 1;

  std::vector<std::string> chosen{draws.pick(required.empty() ? thermal : required)};
  // Data without ramps do not determine a thermal model: such a case gets a chamber test, too.
  if (facts_of(chosen[0]).max_degc <= 30 &&
      facts_of(chosen[0]).kind != ProgrammeFacts::Kind::thermal) {
    wanted = std::max<std::size_t>(wanted, 2);
  }
  std::size_t rows = facts_of(chosen[0]).rows;
  draws.shuffle(thermal);
  for (const std::string& name : thermal) {
    const std::size_t more = facts_of(name).rows;
    if (chosen.size() >= wanted || contains(chosen, name) || rows + more > kMaxRows) continue;
    chosen.push_back(name);
    rows += more;
  }
  return chosen;
}

bool turns(const std::string& programme) {
  return facts_of(programme).kind == ProgrammeFacts::Kind::turning;
}

std::string draw_unseen(Draws& draws, const std::vector<std::string>& seen, bool turning) {
  const auto kind = turning ? ProgrammeFacts::Kind::turning : ProgrammeFacts::Kind::thermal;
  double min = 1e9;
  double max = -1e9;
  double fastest_dps = 0;
  for (const std::string& name : seen) {
    min = std::min(min, facts_of(name).min_degc);
    max = std::max(max, facts_of(name).max_degc);
    fastest_dps = std::max(fastest_dps, facts_of(name).fastest_dps);
  }
  std::vector<std::string> possible;
  for (const ProgrammeFacts& facts : programmes()) {
    if (facts.kind == kind && facts.min_degc >= min && facts.max_degc <= max &&
        facts.fastest_dps <= fastest_dps && !contains(seen, facts.name)) {
      possible.push_back(facts.name);
    }
  }
  return possible.empty() ? "" : draws.pick(possible);
}

}  // namespace fogcomp::bench
