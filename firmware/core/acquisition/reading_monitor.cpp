#include "core/acquisition/reading_monitor.hpp"

namespace fog {
namespace {

constexpr std::uint32_t kOneDegree = from_integer<Temperature>(1).raw();
constexpr std::uint32_t kSecondUs = 1'000'000;
constexpr std::uint32_t kMinuteUs = 60 * kSecondUs;
constexpr std::uint32_t kLongestUs = 3600 * kSecondUs;

// Frozen sensor. Repeated steps of many resolutions are resolved noise: such a sensor never repeats
// its value for long. A sensor without such noise may stand still for hours in a soak. It counts as
// frozen only if thermal mass rules the stop out: it moved by four resolutions and a quarter of a
// degree, and then not at all for two minutes.
constexpr std::uint32_t kLargeStep = 8;  // resolutions
constexpr std::uint32_t kLargeStepsOfNoise = 4;
constexpr std::uint32_t kMaxLargeSteps = 8;
constexpr std::uint32_t kNoiseStandsUs = kMinuteUs;
constexpr std::uint32_t kMoving = 4;  // resolutions
constexpr std::uint32_t kMinMoved = kOneDegree / 4;
constexpr std::uint32_t kMovingStandsUs = 2 * kMinuteUs;

constexpr Status kJump = Status::temperature_invalid | Status::temperature_jump;

std::uint32_t saturating_sum(std::uint32_t a, std::uint32_t b) {
  return b < kLongestUs - a ? a + b : kLongestUs;
}

// |a - b|; exact for any two.
std::uint32_t distance(Temperature a, Temperature b) {
  const auto raw_a = static_cast<std::uint32_t>(a.raw());
  const auto raw_b = static_cast<std::uint32_t>(b.raw());
  return a > b ? raw_a - raw_b : raw_b - raw_a;
}

}  // namespace

template <class Limits>
Status ReadingMonitor<Limits>::judge(Reading reading, bool sensor_valid, std::uint32_t elapsed) {
  const std::uint64_t passed_us = std::uint64_t{elapsed} * sample_period_us_;
  const auto elapsed_us =
      static_cast<std::uint32_t>(passed_us < kLongestUs ? passed_us : kLongestUs);
  since_last_us_ = saturating_sum(since_last_us_, elapsed_us);
  use_ = ReadingUse::none;
  const bool possible = reading >= this->min && reading <= this->max;
  if (!sensor_valid || !possible) return Status::temperature_invalid;
  const bool agrees = !is_step(reading, before_);
  agreed_us_ = agrees ? saturating_sum(agreed_us_, elapsed_us) : 0;
  before_ = reading;
  if (!started_) return judge_first(reading, elapsed_us);
  if (jumped(reading, agrees && agreed_us_ >= confirm_us_)) {
    refused_ = refused_ || !can_be_reached(reading);
    return kJump;
  }
  const bool anew = frozen_ || (refused_ && is_step(reading, last_));
  follow(reading, elapsed_us);
  frozen_ = is_frozen();
  if (frozen_) return Status::temperature_invalid | Status::temperature_frozen;
  refused_ = false;
  use_ = anew ? ReadingUse::good_new_history : ReadingUse::good;
  return Status::none;
}

// Before its first conversion a sensor may repeat its power-on value.
template <class Limits>
Status ReadingMonitor<Limits>::judge_first(Reading reading, std::uint32_t elapsed_us) {
  if (is_power_on_reading(reading)) return kJump;
  use_ = agreed_us_ > 0 ? ReadingUse::good : ReadingUse::good_new_history;
  if (agreed_us_ >= confirm_us_) follow(reading, elapsed_us);
  return Status::none;
}

template <class Limits>
bool ReadingMonitor<Limits>::is_power_on_reading(Reading reading) const {
  return this->has_thermal_mass && reading == kPowerOnReading;
}

template <class Limits>
bool ReadingMonitor<Limits>::is_step(Reading a, Reading b) const {
  return distance(a, b) > static_cast<std::uint32_t>(this->step.raw());
}

template <class Limits>
bool ReadingMonitor<Limits>::can_be_reached(Reading reading) const {
  if (!this->has_thermal_mass) return true;
  const std::int64_t beyond = std::int64_t{distance(reading, last_)} - this->step.raw();
  return beyond * kSecondUs <= std::int64_t{kOneDegree} * since_last_us_;
}

// A new value is accepted once the quantity can have reached it and the preceding readings agree
// with it; an alternating one is never accepted. The power-on reading counts as a jump unless the
// temperature was seen to approach it.
template <class Limits>
bool ReadingMonitor<Limits>::jumped(Reading reading, bool confirmed) const {
  if (is_power_on_reading(reading)) return distance(reading, last_) > kOneDegree;
  return is_step(reading, last_) && (!confirmed || !can_be_reached(reading));
}

template <class Limits>
bool ReadingMonitor<Limits>::is_frozen() const {
  if (unchanged_us_ < kNoiseStandsUs) return false;
  const bool shows_noise = large_steps_ >= kLargeStepsOfNoise;
  const bool was_moving =
      this->has_thermal_mass && moved_ >= kMinMoved && moved_ / kMoving >= resolution_;
  return shows_noise || (was_moving && unchanged_us_ >= kMovingStandsUs);
}

template <class Limits>
void ReadingMonitor<Limits>::follow(Reading reading, std::uint32_t elapsed_us) {
  if (!started_) last_ = at_minute_ = minute_before_ = reading;
  started_ = true;
  since_last_us_ = 0;
  if (reading == last_) {
    unchanged_us_ = saturating_sum(unchanged_us_, elapsed_us);
  } else {
    learn_step(reading);
    unchanged_us_ = 0;
    last_ = reading;
  }
  minute_us_ = saturating_sum(minute_us_, elapsed_us);
  if (minute_us_ >= kMinuteUs) {
    minute_us_ = 0;
    minute_before_ = at_minute_;
    at_minute_ = reading;
  }
}

template <class Limits>
void ReadingMonitor<Limits>::learn_step(Reading reading) {
  const std::uint32_t change = distance(reading, last_);
  if (change < resolution_) resolution_ = change;
  if (change / kLargeStep < resolution_) {
    if (large_steps_ > 0) --large_steps_;
  } else if (large_steps_ < kMaxLargeSteps) {
    ++large_steps_;
  }
  moved_ = distance(reading, minute_before_);
}

template class ReadingMonitor<CoilLimits>;
template class ReadingMonitor<InputLimits>;

}  // namespace fog
