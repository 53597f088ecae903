#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "support/drift_under_faults.hpp"
#include "support/faulty_line.hpp"
#include "support/text.hpp"
#include "support/typical_effects.hpp"

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
constexpr double kApartS = 800;  // at most, of what is drawn one after the other
constexpr double kMaxTurnDps = 500;
constexpr double kMaxDegcPerMin = 3;

/// Every kind; one may be drawn in more than one way.
inline constexpr FaultDraw kFaultDraws[] = {
    {Fault::Kind::no_temperature, "temperature missing", kShortestS, kLongestS},
    {Fault::Kind::no_samples, "samples lost", kShortestS, kLongestS},
    {Fault::Kind::restart, "demodulator restarts at", kShortestS, kLongestS, 0, 65536},
    {Fault::Kind::restart_ahead, "demodulator restarts ahead by", 0.05, 2, 1, 65535},
    {Fault::Kind::wrong_temperature, "temperature of", kShortestS, kLongestS, -80, 140},
    {Fault::Kind::temperature_offset, "temperature off by", kShortestS, kLongestS, -30, 30},
    {Fault::Kind::temperature_drifts, "temperature drifts, degC/min:", 5, kLongestS, -4, 4},
    // Of more, the means of blocks that begin elsewhere than the witness's are other ones.
    {Fault::Kind::temperature_noise, "temperature noisy, degC:", kShortestS, kLongestS, 0.01, 0.3},
    {Fault::Kind::frozen_temperature, "temperature frozen", kShortestS, kLongestS},
    {Fault::Kind::sample_period, "sample period, us:", kShortestS, kLongestS, 0.368, 2.718},
    // As wrong as a bad crystal or a resonator is.
    {Fault::Kind::sample_period, "sample period, us:", 1, 10 * kLongestS, 0.97, 1.03},
    {Fault::Kind::repeated, "samples repeated", kShortestS, kLongestS},
    {Fault::Kind::swapped, "samples swapped", kShortestS, kLongestS},
    {Fault::Kind::sparse, "one sample of", kShortestS, kLongestS, 2, 1000},
    {Fault::Kind::leaps, "numbers leap by", 1, kLongestS, 1, 1000},
    {Fault::Kind::repeats_one, "one sample again and again", kShortestS, kLongestS},
    {Fault::Kind::bits_flipped, "a bit flipped in one sample of", kShortestS, kLongestS, 1, 1000},
    {Fault::Kind::bytes_lost, "a byte lost in one sample of", kShortestS, kLongestS, 1, 1000},
    {Fault::Kind::bytes_added, "bytes added to one sample of", kShortestS, kLongestS, 1, 1000},
    {Fault::Kind::gyro_invalid, "gyro invalid", kShortestS, kLongestS},
    {Fault::Kind::gyro_noise, "gyro noisy, deg/s:", kShortestS, kLongestS, 0.001, 100},
    {Fault::Kind::gyro_stands, "gyro stands, noise of", kShortestS, kLongestS, 0, 30},
    {Fault::Kind::gyro_level, "gyro at, deg/s:", kShortestS, kLongestS, -580, 580},
    {Fault::Kind::gyro_spikes, "spikes, deg/s:", kShortestS, kLongestS, 1, 580},
    {Fault::Kind::gyro_sign, "gyro's sign flips", kShortestS, kLongestS},
    {Fault::Kind::input_missing, "input missing", kShortestS, kLongestS},
    {Fault::Kind::input_sparse, "one record of", kShortestS, kLongestS, 2, 1000},
    {Fault::Kind::input_frozen, "input frozen", kShortestS, kLongestS},
    {Fault::Kind::input_late, "input late, s:", kShortestS, kLongestS, 0.1, 100},
    // From within its trained range to far beyond what the table lets pass.
    {Fault::Kind::input_wrong, "input at, amplitudes:", kShortestS, kLongestS, -10, 10},
    {Fault::Kind::input_offset, "input off by, amplitudes:", kShortestS, kLongestS, -2, 2},
    // Of more, only those pass that lie within a step of the last one: with_input().
    {Fault::Kind::input_noise, "input noisy, amplitudes:", kShortestS, kLongestS, 0.0001, 0.01},
    {Fault::Kind::input_damaged, "one record damaged of", kShortestS, kLongestS, 1, 1000},
    {Fault::Kind::input_other_kind, "records of an input so much on:", kShortestS, kLongestS, 1,
     255},
    {Fault::Kind::power_cycle, "power lost", 0.1, kLongestS},
    // The watchdog expires after 0.1 s; a start takes another 0.1 s.
    {Fault::Kind::board_restart, "board restarts", 0.05, 1},
    {Fault::Kind::pin_reset, "reset by the pin", kShortestS, kLongestS},
};
constexpr std::size_t kDraws = sizeof kFaultDraws / sizeof kFaultDraws[0];

constexpr bool has_every_kind() {
  std::uint64_t kinds = 0;
  for (const FaultDraw& draw : kFaultDraws) {
    kinds |= std::uint64_t{1} << static_cast<unsigned>(draw.kind);
  }
  return kinds == (std::uint64_t{1} << kFaultKinds) - 1;
}
static_assert(has_every_kind());

constexpr bool is_of_input(Fault::Kind kind) {
  return kind >= Fault::Kind::input_missing && kind <= Fault::Kind::input_other_kind;
}

inline const char* name_of(Fault::Kind kind) {
  for (const FaultDraw& draw : kFaultDraws) {
    if (draw.kind == kind) return draw.name;
  }
  return "?";
}

/// What of the temperature's past a model knows; 0: not that.
struct ThermalMemory {
  double lag_s = 0;
  double loop_degc = 0;  ///< half of its width; in narrow ones a sensor step moves the drift
  double warm_up_s = 0;

  bool any() const { return lag_s > 0 || loop_degc > 0 || warm_up_s > 0; }
};

/// The paper's model with such terms, as effects and as expressions.
inline fogcomp::model::Model with_memory(const ThermalMemory& memory) {
  fogcomp::model::Model model = paper_like_model();
  // The board knows from it for how long a held drift is as good as the model.
  model.rate_range_degc_per_min = fogcomp::model::Range{-kMaxDegcPerMin, kMaxDegcPerMin};
  if (memory.lag_s > 0) {
    model.terms.push_back(natural_term("thermal_lag", {memory.lag_s}, {0.3}));
    model.terms.push_back(written_term(fogcomp::format("late = lag(T,%.1f)-T", memory.lag_s / 2)));
  }
  if (memory.loop_degc > 0) {
    model.terms.push_back(
        natural_term("thermal_hysteresis", {memory.loop_degc, 2 * memory.loop_degc}, {0.3, 0.2}));
    model.terms.push_back(written_term(fogcomp::format("loop = play(T,%.1f)", memory.loop_degc)));
  }
  if (memory.warm_up_s > 0) {
    model.terms.push_back(natural_term("warm_up", {memory.warm_up_s}, {0.5}));
  }
  return model;
}

/// The model with a term of an input beside the temperature, of 0.5 to 1 deg/h over its swing.
inline fogcomp::model::Model with_input(fogcomp::model::Model model, const InputCourse& course) {
  constexpr double kWrittenWeight = 25;
  const auto add_written = [&](const char* text) {
    model.terms.push_back(written_term(text));
    model.terms.back().coefficients_dph[0].value *= kWrittenWeight;
  };
  fogcomp::model::Range range{course.middle() - course.amplitude(),
                              course.middle() + course.amplitude()};
  switch (course.input) {
    case Input::temperature2:
      model.terms.push_back(natural_term("axial_gradient", {30}, {0.9, 0.1}));
      range = {model.min_degc + range.min, model.max_degc + range.max};
      break;
    case Input::magnetic:
      model.terms.push_back(natural_term("magnetic", {}, {0.005, 5e-6}));
      break;
    case Input::light_power:
      model.terms.push_back(natural_term("light_power", {}, {0.3}));
      break;
    case Input::supply:
      add_written("volts = lag(V,20)+V-10");
      break;
    default:
      add_written("shaken = lag(g,60)");
      break;
  }
  model.input_ranges[extension_number(course.input)] = {range, course.amplitude() / 50};
  return model;
}

/// The model with a network and expressions so large that a signal clamped unseen would show.
inline fogcomp::model::Model with_large_terms(fogcomp::model::Model model) {
  constexpr double kLarger = 10;
  model.network.amplitude_dph *= kLarger;
  for (fogcomp::model::EffectTerm& term : model.terms) {
    const bool is_of_input = term.name == "volts" || term.name == "shaken";  // as large already
    if (term.expression && !is_of_input) term.coefficients_dph[0].value *= kLarger;
  }
  return model;
}

/// A board, what happens to it, and for how long: kSamples, or the shortest run if that is longer,
/// which is a few times what the model takes to settle.
struct FaultSchedule {
  static constexpr double kSamples = 1e6;
  static constexpr double kShortestRunS = 1000;
  static constexpr double kShortestMemoryRunS = 2000;

  TestedBoard board;
  ThermalMemory memory;
  double duration_s = 0;
  std::vector<Fault> faults;
};

/// Faults one after the other and upon each other, in intervals long enough for trusted rates
/// between them. The same for the same seed.
class FaultScheduler {
 public:
  explicit FaultScheduler(std::uint64_t seed) : random_(seed) {}

  FaultSchedule draw() {
    board_ = board();
    FaultSchedule schedule;
    schedule.board = board_;
    if (chance(0.3)) schedule.memory = memory();
    if (chance(0.4)) board_.input = schedule.board.input = input();
    schedule.duration_s = std::max(
        FaultSchedule::kSamples / board_.sample_rate_hz,
        schedule.memory.any() ? FaultSchedule::kShortestMemoryRunS : FaultSchedule::kShortestRunS);
    if (chance(0.3)) schedule.faults.push_back(fault(0));
    for (double time_s = uniform(0, kApartS); time_s < schedule.duration_s;
         time_s += uniform(0, kApartS)) {
      do {
        schedule.faults.push_back(fault(time_s + uniform(0, 100)));
      } while (chance(0.4));  // with what else
    }
    if (chance(0.3)) schedule.board.trained_part = uniform(0.2, 1);
    if (board_.image == ImageKind::generic && chance(0.4)) schedule.board.denoise = denoiser();
    return schedule;
  }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }

  TestedBoard board() {
    TestedBoard setting;
    setting.has_clock = chance(0.5);
    setting.sample_rate_hz = logarithmic(10, 5000);
    setting.frames = kFrameChoices[random_() % kFrameChoices.size()];
    setting.image = chance(0.5) ? ImageKind::generic : ImageKind::specialised;
    setting.turns_dps = chance(0.5) ? uniform(0, kMaxTurnDps) : 0;
    setting.has_reset_clock = chance(0.3);
    setting.judged_by_validity = setting.frames.output == OutputSelection::kvh;
    // The coil is between -38 and 58 degC.
    if (chance(0.3)) setting.trained = fogcomp::model::Range{uniform(-40, 0), uniform(25, 60)};
    return setting;
  }

  InputCourse input() {
    constexpr double kLongestPeriodS = 3000;
    InputCourse course{extension_input(random_() % kExtensionInputs), 50};
    // A second temperature changes no faster than the coil's.
    if (course.input == Input::temperature2) {
      course.period_s = 2 * M_PI * course.amplitude() / (kMaxDegcPerMin / 60);
    }
    course.period_s = logarithmic(course.period_s, kLongestPeriodS);
    return course;
  }

  ThermalMemory memory() {
    return {chance(0.6) ? logarithmic(10, 120) : 0, chance(0.6) ? logarithmic(2, 8) : 0,
            chance(0.4) ? logarithmic(10, 200) : 0};
  }

  fogcomp::model::DenoiseSettings denoiser() {
    constexpr std::array kWavelets{"haar", "db4", "sym8"};
    constexpr int kMaxLevels = 6;
    return {kWavelets[random_() % kWavelets.size()],
            1 + static_cast<int>(random_() % std::uint64_t{kMaxLevels}), rule(), chance(0.5)};
  }
  ThresholdRule rule() { return static_cast<ThresholdRule>(random_() % 3U); }

  Fault fault(double from_s) {
    const FaultDraw& draw = kFaultDraws[random_() % kDraws];
    // Without a clock nobody can find it: not promised (firmware/DESIGN.md).
    if (draw.kind == Fault::Kind::sample_period && !board_.has_clock) return fault(from_s);
    if (is_of_input(draw.kind) && !board_.input) return fault(from_s);
    const double lasts_s = logarithmic(draw.shortest_s, draw.longest_s);
    double value = draw.lowest > 0 ? logarithmic(draw.lowest, draw.highest)
                                   : uniform(draw.lowest, draw.highest);
    if (draw.kind == Fault::Kind::sparse || draw.kind == Fault::Kind::input_sparse)
      value = std::floor(value);
    if (draw.kind == Fault::Kind::sample_period) value *= 1e6 / board_.sample_rate_hz;
    return {draw.kind, from_s, from_s + lasts_s, value};
  }

  std::mt19937_64 random_;
  TestedBoard board_;
};

/// As DriftUnderFaults::run(), for the board of the schedule.
inline DriftVerdict run(const FaultSchedule& schedule, std::uint64_t seed) {
  fogcomp::model::Model model = with_memory(schedule.memory);
  if (schedule.board.input) model = with_input(model, *schedule.board.input);
  if (schedule.board.trained_part != 1) model = with_large_terms(std::move(model));
  return DriftUnderFaults(model, kMaxDegcPerMin, schedule.board)
      .run(schedule.faults, schedule.duration_s, seed);
}

/// Why a user was misled, in words; "" if he was not.
inline std::string complaint(const DriftVerdict& verdict) {
  constexpr double kBoundDph = 0.05;
  std::string text;
  if (verdict.worst_dph > kBoundDph) {
    text += fogcomp::format("off by %.3f deg/h at %.2f s; ", verdict.worst_dph, verdict.worst_at_s);
  }
  if (verdict.trusted_wrong > 0) {
    text += fogcomp::format("a gyro that stands or leaps was trusted at %.2f s; ",
                            verdict.trusted_wrong_at_s);
  }
  if (verdict.denoised_wrong > 0) {
    text += fogcomp::format("%llu denoised rates are another sample's, the last at %.2f s; ",
                            static_cast<unsigned long long>(verdict.denoised_wrong),
                            verdict.denoised_wrong_at_s);
  }
  if (verdict.false_frames > 0) text += "frames say something else than the board has found; ";
  return text;
}

/// What is needed to run it again by itself.
inline void print(const FaultSchedule& schedule) {
  const TestedBoard& board = schedule.board;
  std::printf("  %s, %.6g Hz for %.0f s, frames %d options %d, %s, turns by %.0f deg/s\n",
              board.has_clock ? "with a crystal" : "without a clock", board.sample_rate_hz,
              schedule.duration_s, static_cast<int>(board.frames.output), board.frames.options,
              board.image == ImageKind::generic ? "generic" : "specialised", board.turns_dps);
  if (board.has_reset_clock) std::printf("  a clock that outlasts a reset\n");
  if (board.trained) {
    std::printf("  trained from %.2f to %.2f degC\n", board.trained->min, board.trained->max);
  }
  if (board.trained_part != 1) {
    std::printf("  network and expressions trained for %.3f of it\n", board.trained_part);
  }
  if (board.denoise.levels > 0) {
    std::printf("  denoised by %s x %d, rule %d\n", board.denoise.wavelet.c_str(),
                board.denoise.levels, static_cast<int>(board.denoise.rule));
  }
  if (schedule.memory.any()) {
    std::printf("  lag of %.1f s, loop of %.2f degC, warm-up of %.1f s\n", schedule.memory.lag_s,
                schedule.memory.loop_degc, schedule.memory.warm_up_s);
  }
  if (board.input) {
    std::printf("  %s in a period of %.1f s\n", description_of(board.input->input).name,
                board.input->period_s);
  }
  for (const Fault& fault : schedule.faults) {
    std::printf("  %.3f to %.3f s: %s %g\n", fault.from_s, fault.to_s, name_of(fault.kind),
                fault.value);
  }
}

}  // namespace fog::test
