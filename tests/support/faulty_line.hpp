#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "board/replay.hpp"
#include "support/board_image.hpp"
#include "support/sample_models.hpp"

// A demodulator with faults, to test whether the drift is still right.
namespace fog::test {

constexpr std::int64_t kPeriodUs = 5000;
constexpr std::int64_t kSecondUs = 1'000'000;

/// Faults between two times.
struct Fault {
  enum class Kind : std::uint8_t {
    no_temperature,      ///< flagged by the sensor
    no_samples,          ///< the line is dead; the demodulator continues to count
    restart,             ///< the demodulator restarts and counts from `value`
    restart_ahead,       ///< the same, from `value` numbers ahead
    wrong_temperature,   ///< `value` degC, flagged as valid
    temperature_offset,  ///< `value` degC too warm
    temperature_drifts,  ///< by `value` degC/min
    temperature_noise,   ///< uniform, up to `value` degC of either sign
    frozen_temperature,  ///< the reading at the start of the fault, repeated
    sample_period,       ///< `value` us instead of kPeriodUs
    repeated,            ///< every fourth sample comes twice
    swapped,             ///< every fourth sample comes after its successor
    sparse,              ///< only every `value`th sample arrives
    leaps,               ///< the number leaps ahead by `value`, once a second
    repeats_one,   ///< a FIFO that stands: the sample at the start of the fault, again and again
    bits_flipped,  ///< of one byte in one sample of `value`
    bytes_lost,    ///< likewise, one byte
    bytes_added,   ///< likewise, before the sample
    gyro_invalid,
    gyro_noise,   ///< uniform, up to `value` deg/s of either sign
    gyro_stands,  ///< the loop: the reading at the start of the fault, and `value` counts of noise
    gyro_level,   ///< a converter that stands: `value` deg/s
    gyro_spikes,  ///< one sample of 50 is `value` deg/s, of either sign
    gyro_sign,    ///< the sign has flipped
    input_missing,     ///< no extension record comes
    input_sparse,      ///< only every `value`th does
    input_frozen,      ///< the value at the start of the fault, repeated
    input_late,        ///< the value of `value` seconds ago
    input_wrong,       ///< `value` amplitudes from the middle of its swing
    input_offset,      ///< `value` amplitudes too high
    input_noise,       ///< uniform, up to `value` amplitudes of either sign
    input_damaged,     ///< a bit flipped, a byte lost or added in one record of `value`
    input_other_kind,  ///< the record says another input, `value` numbers on
    power_cycle,       ///< the board loses its memory at the end
    board_restart,     ///< the board restarts by itself and keeps its memory
    pin_reset,         ///< the same by the reset pin, held for any time
  };
  Kind kind;
  double from_s;
  double to_s;
  double value = 0;
};

constexpr std::size_t kFaultKinds = static_cast<std::size_t>(Fault::Kind::pin_reset) + 1;

/// The faults of a time. They may be changed there, for as long as they last.
class FaultsInTime {
 public:
  explicit FaultsInTime(std::vector<Fault> faults) : faults_(std::move(faults)) {}

  /// For non-decreasing times; valid until the next call.
  const std::vector<Fault*>& at(double time_s) {
    if (time_s >= next_change_s_) find(time_s);
    return present_;
  }

 private:
  void find(double time_s) {
    present_.clear();
    next_change_s_ = std::numeric_limits<double>::infinity();
    for (Fault& fault : faults_) {
      if (time_s >= fault.from_s && time_s < fault.to_s) present_.push_back(&fault);
      for (const double change_s : {fault.from_s, fault.to_s}) {
        if (change_s > time_s) next_change_s_ = std::min(next_change_s_, change_s);
      }
    }
  }

  std::vector<Fault> faults_;
  std::vector<Fault*> present_;
  double next_change_s_ = 0;
};

/// Readings of a 1/16 degC sensor on a coil in a chamber with random ramps and soaks. The coil has
/// the lag of a bare one; the sensor's noise is one step.
class CoilTemperature {
 public:
  CoilTemperature(std::uint64_t seed, double ramp_degc_per_min)
      : random_(seed), ramp_degc_per_s_(ramp_degc_per_min / 60) {}

  /// For non-decreasing times.
  double at(double time_s) {
    while (time_s >= end_s_) begin_part();
    const double turns = 7919 * time_s / (2 * M_PI);
    const double noise_degc = kResolutionDegc * (2 * (turns - std::floor(turns)) - 1);
    return kResolutionDegc * std::floor((coil_degc(time_s) + noise_degc) / kResolutionDegc);
  }

 private:
  static constexpr double kLagS = 45;
  static constexpr double kResolutionDegc = 1.0 / 16;

  double chamber_degc(double time_s) const {
    return chamber_degc_ + (time_s - start_s_) * slope_degc_per_s_;
  }
  // The closed form of a first-order lag behind a ramp.
  double coil_degc(double time_s) const {
    return chamber_degc(time_s) - slope_degc_per_s_ * kLagS +
           unsettled_degc_ * std::exp(-(time_s - start_s_) / kLagS);
  }
  void begin_part() {
    const double coil = coil_degc(end_s_);
    chamber_degc_ = chamber_degc(end_s_);
    start_s_ = end_s_;
    end_s_ += std::uniform_real_distribution<double>(20, 600)(random_);
    const double kind = std::uniform_real_distribution<double>(0, 1)(random_);
    double slope = kind < 0.3 ? 0 : ramp_degc_per_s_;
    if (kind < 0.6) slope = -slope;
    const double reached = chamber_degc_ + (end_s_ - start_s_) * slope;
    slope_degc_per_s_ = reached > -35 && reached < 55 ? slope : -slope;
    unsettled_degc_ = coil - chamber_degc_ + slope_degc_per_s_ * kLagS;
  }

  std::mt19937_64 random_;
  double ramp_degc_per_s_;
  double start_s_ = 0;
  double end_s_ = 0;
  double chamber_degc_ = 20;
  double slope_degc_per_s_ = 0;
  double unsettled_degc_ = 0;
};

/// An input beside the coil's temperature: the swing of its description, in another period.
struct InputCourse {
  Input input;
  double period_s;

  double middle() const { return swing().middle_milli / 1000.0; }
  double amplitude() const { return swing().amplitude_milli / 1000.0; }
  double at(double time_s, double coil_degc) const {
    const double value = middle() + amplitude() * std::sin(2 * M_PI * time_s / period_s);
    return input == Input::temperature2 ? coil_degc + value : value;
  }

 private:
  const InputSwing& swing() const { return description_of(input).swing; }
};

/// How often a demodulator samples, how the gyro turns: as a sine of 100 s, and the input whose
/// record comes before each sample.
struct LineSetting {
  std::int64_t period_us = kPeriodUs;
  double turns_dps = 0;  ///< amplitude
  std::optional<InputCourse> input{};
};

/// Time-stamped samples of a demodulator with these faults.
class FaultyLine {
 public:
  struct Arrival {
    std::int64_t time_us;
    SensorSample sample;
    double true_degc;
    LineDamage damage;
    bool gyro_stands;                    ///< whatever it whispers
    std::optional<LineRecord> record{};  ///< before the sample
    double true_input = 0;
  };

  FaultyLine(std::vector<Fault> faults, std::uint64_t seed, double max_degc_per_min,
             const LineSetting& setting = {})
      : faults_(std::move(faults)),
        coil_(seed, max_degc_per_min),
        random_(seed + 1),
        setting_(setting) {
    sequence_ = static_cast<std::uint16_t>(random_());
  }

  /// The samples of the next time step, in their order of arrival: none, one or two. Valid until
  /// the next call.
  const std::vector<Arrival>& next() {
    const double time_s = static_cast<double>(time_us_) * 1e-6;
    Arrival now{time_us_, {}, coil_.at(time_s), {}, false};
    now.sample.sequence = sequence_;
    now.sample.rate_counts = static_cast<std::int32_t>(random_() % 4001U) - 2000;
    if (setting_.turns_dps != 0) {
      now.sample.rate_counts += counts(setting_.turns_dps * std::sin(2 * M_PI * time_s / kTurnS));
    }
    now.sample.temperature_q16 = raw(now.true_degc);
    now.sample.gyro_valid = now.sample.temperature_valid = true;
    if (setting_.input) add_record(now, time_s);
    const bool arrives = spoil(now, time_s);
    time_us_ += period_us_;
    ++sequence_;
    arrivals_.clear();
    if (arrives && swap_) {
      kept_ = now;
      return arrivals_;
    }
    if (arrives) arrivals_.push_back(now);
    if (arrives && repeat_) arrivals_.push_back(now);
    if (arrives && kept_) {
      kept_->time_us = now.time_us;
      arrivals_.push_back(*kept_);
      kept_.reset();
    }
    return arrivals_;
  }

  /// Of the next time step.
  std::int64_t time_us() const { return time_us_; }

 private:
  static constexpr double kTurnS = 100;

  static std::int32_t raw(double degc) { return static_cast<std::int32_t>(degc * 65536); }
  std::int32_t counts(double dps) const { return static_cast<std::int32_t>(dps * counts_per_dps_); }

  void add_record(Arrival& now, double time_s) {
    using Kind = Fault::Kind;
    const InputCourse& course = *setting_.input;
    double value = now.true_input = course.at(time_s, now.true_degc);
    now.record = LineRecord{ExtensionRecord{course.input, {}}};
    bool comes = true;
    const std::vector<Fault*>& present = faults_.at(time_s);
    if (!has(present, Kind::input_frozen)) frozen_input_.reset();
    for (const Fault* const fault : present) {
      const double drawn = fault->value;
      switch (fault->kind) {
        case Kind::input_missing:
          comes = false;
          break;
        case Kind::input_sparse:
          comes = comes && sequence_ % static_cast<unsigned>(drawn) == 0;
          break;
        case Kind::input_frozen:
          if (!frozen_input_) frozen_input_ = value;
          value = *frozen_input_;
          break;
        case Kind::input_late:
          value = course.at(time_s - drawn, now.true_degc);
          break;
        case Kind::input_wrong:
          value = course.middle() + drawn * course.amplitude();
          break;
        case Kind::input_offset:
          value += drawn * course.amplitude();
          break;
        case Kind::input_noise:
          value += std::ldexp(either_way(raw(drawn * course.amplitude())), -16);
          break;
        case Kind::input_damaged:
          if (random_() % static_cast<unsigned>(drawn) != 0) break;
          now.record->damage = {static_cast<LineDamage::Kind>(1 + random_() % 3U),
                                static_cast<std::uint32_t>(random_())};
          break;
        case Kind::input_other_kind:
          now.record->other_kind = static_cast<std::uint8_t>(drawn);
          break;
        default:
          break;
      }
    }
    now.record->record.value = ExtensionValue::from_raw(raw(value));
    if (!comes) now.record.reset();
  }

  bool spoil(Arrival& now, double time_s) {
    using Kind = Fault::Kind;
    bool arrives = true;
    repeat_ = swap_ = false;
    const std::vector<Fault*>& present = faults_.at(time_s);
    if (!has(present, Kind::repeats_one)) standing_.reset();
    if (!has(present, Kind::gyro_stands)) stood_.reset();
    period_us_ = setting_.period_us;
    for (Fault* const present_one : present) {
      Fault& fault = *present_one;
      switch (fault.kind) {
        case Kind::no_temperature:
          now.sample.temperature_valid = false;
          break;
        case Kind::no_samples:
          arrives = false;
          break;
        case Kind::restart:
          arrives = false;
          sequence_ = static_cast<std::uint16_t>(fault.value);
          break;
        case Kind::restart_ahead:
          arrives = false;
          if (!restarted_) sequence_ = ahead(sequence_, fault.value);
          break;
        case Kind::wrong_temperature:
          now.sample.temperature_q16 = raw(fault.value);
          break;
        case Kind::temperature_offset:
          now.sample.temperature_q16 += raw(fault.value);
          break;
        case Kind::temperature_drifts:
          now.sample.temperature_q16 += raw(fault.value / 60 * (time_s - fault.from_s));
          break;
        case Kind::temperature_noise:
          now.sample.temperature_q16 += either_way(raw(fault.value));
          break;
        case Kind::frozen_temperature:
          if (fault.value == 0) fault.value = now.true_degc + 1e-6;
          now.sample.temperature_q16 = raw(fault.value);
          break;
        case Kind::sample_period:
          period_us_ = static_cast<std::int64_t>(fault.value);
          break;
        case Kind::repeated:
          repeat_ = sequence_ % 4U == 0;
          break;
        case Kind::swapped:
          swap_ = sequence_ % 4U == 0;
          break;
        case Kind::sparse:
          arrives = arrives && sequence_ % static_cast<unsigned>(fault.value) == 0;
          break;
        case Kind::leaps:
          if (time_us_ % kSecondUs < setting_.period_us) sequence_ = ahead(sequence_, fault.value);
          now.sample.sequence = sequence_;
          break;
        case Kind::repeats_one:
          if (!standing_) standing_ = now.sample;
          now.sample = *standing_;
          now.gyro_stands = true;
          break;
        case Kind::bits_flipped:
          damage(now, fault, LineDamage::Kind::bit_flipped);
          break;
        case Kind::bytes_lost:
          damage(now, fault, LineDamage::Kind::byte_lost);
          break;
        case Kind::bytes_added:
          damage(now, fault, LineDamage::Kind::bytes_added);
          break;
        case Kind::gyro_invalid:
          now.sample.gyro_valid = false;
          break;
        case Kind::gyro_noise:
          now.sample.rate_counts += either_way(counts(fault.value));
          break;
        case Kind::gyro_stands:
          if (!stood_) stood_ = now.sample.rate_counts;
          now.gyro_stands = true;
          now.sample.rate_counts = *stood_ + either_way(static_cast<std::int32_t>(fault.value));
          break;
        case Kind::gyro_level:
          now.sample.rate_counts = counts(fault.value);
          now.gyro_stands = true;
          break;
        case Kind::gyro_spikes:
          if (random_() % 50U == 0) {
            now.sample.rate_counts = counts(random_() % 2U == 0 ? fault.value : -fault.value);
          }
          break;
        case Kind::gyro_sign:
          now.sample.rate_counts = -now.sample.rate_counts;
          break;
        case Kind::power_cycle:
        case Kind::board_restart:
        case Kind::pin_reset:
          arrives = false;
          break;
        default:  // add_record()
          break;
      }
    }
    restarted_ = has(present, Kind::restart_ahead);
    return arrives;
  }

  // One of -largest to largest.
  std::int32_t either_way(std::int32_t largest) {
    const auto choices = 2U * static_cast<unsigned>(largest) + 1U;
    return static_cast<std::int32_t>(random_() % choices) - largest;
  }

  void damage(Arrival& now, const Fault& fault, LineDamage::Kind kind) {
    if (random_() % static_cast<unsigned>(fault.value) != 0) return;
    now.damage = {kind, static_cast<std::uint32_t>(random_())};
  }

  static bool has(const std::vector<Fault*>& faults, Fault::Kind kind) {
    return std::any_of(faults.begin(), faults.end(),
                       [kind](const Fault* fault) { return fault->kind == kind; });
  }
  static std::uint16_t ahead(std::uint16_t sequence, double by) {
    return static_cast<std::uint16_t>(sequence + static_cast<unsigned>(by));
  }

  FaultsInTime faults_;
  CoilTemperature coil_;
  std::mt19937_64 random_;
  LineSetting setting_;
  double counts_per_dps_ = paper_like_model().scale_factor;
  std::int64_t time_us_ = 0;
  std::int64_t period_us_ = kPeriodUs;
  std::uint16_t sequence_ = 0;
  bool repeat_ = false;
  bool swap_ = false;
  bool restarted_ = false;
  std::optional<SensorSample> standing_;
  std::optional<std::int32_t> stood_;
  std::optional<double> frozen_input_;
  std::optional<Arrival> kept_;
  std::vector<Arrival> arrivals_;
};

}  // namespace fog::test
