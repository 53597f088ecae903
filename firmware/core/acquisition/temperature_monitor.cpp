#include "core/acquisition/temperature_monitor.hpp"

namespace fog {
namespace {

constexpr std::int32_t kOneDegree = from_integer<Temperature>(1).raw();
constexpr std::uint32_t kSecondUs = 1'000'000;
constexpr std::uint32_t kMinuteUs = 60 * kSecondUs;
constexpr std::uint32_t kLongestUs = 3600 * kSecondUs;

// A coil in its housing follows the worst thermal shock by tenths of a degree a second. So 1 degC a
// second since the last good reading, and 2 degC for the sensor's own noise and resolution.
constexpr std::int64_t kStepAtOnce = 2 * kOneDegree;

// Steps of many resolutions, again and again, are noise that the sensor resolves: it never stands
// still. Anything less may stand for hours in a soak, and is frozen only where thermal mass forbids
// a stop: it moved by four resolutions and a quarter of a degree, and then by nothing for two
// minutes.
constexpr std::int32_t kLargeStep = 8;  // resolutions
constexpr std::uint32_t kLargeStepsOfNoise = 4;
constexpr std::uint32_t kMostLargeSteps = 8;
constexpr std::uint32_t kNoiseStandsUs = kMinuteUs;
constexpr std::int32_t kMoving = 4;  // resolutions
constexpr std::int32_t kMovingAtLeast = kOneDegree / 4;
constexpr std::uint32_t kMovingStandsUs = 2 * kMinuteUs;

constexpr Status kJump = Status::temperature_invalid | Status::temperature_jump;

std::uint32_t saturating_sum(std::uint32_t a, std::uint32_t b) {
  return b < kLongestUs - a ? a + b : kLongestUs;
}

// Readings are possible ones: no overflow.
std::int32_t distance(Temperature a, Temperature b) {
  return a > b ? a.raw() - b.raw() : b.raw() - a.raw();
}

}  // namespace

Status TemperatureMonitor::judge(Temperature reading, bool sensor_valid, std::uint32_t elapsed) {
  const std::uint64_t passed_us = std::uint64_t{elapsed} * sample_period_us_;
  const auto elapsed_us =
      static_cast<std::uint32_t>(passed_us < kLongestUs ? passed_us : kLongestUs);
  since_last_us_ = saturating_sum(since_last_us_, elapsed_us);
  use_ = TemperatureUse::none;
  if (!sensor_valid || !is_possible(reading)) return Status::temperature_invalid;
  const bool agrees = distance(reading, before_) <= kStepAtOnce;
  agreed_us_ = agrees ? saturating_sum(agreed_us_, elapsed_us) : 0;
  before_ = reading;
  if (!started_) return judge_first(reading, elapsed_us);
  if (jumped(reading, agrees && agreed_us_ >= confirm_us_)) {
    refused_ = refused_ || !can_be_reached(reading);
    return kJump;
  }
  const bool anew = frozen_ || (refused_ && is_far(reading));
  follow(reading, elapsed_us);
  frozen_ = is_frozen();
  if (frozen_) return Status::temperature_invalid | Status::temperature_frozen;
  refused_ = false;
  use_ = anew ? TemperatureUse::good_anew : TemperatureUse::good;
  return Status::none;
}

// A sensor before its first conversion says something, once or for as long as that takes.
Status TemperatureMonitor::judge_first(Temperature reading, std::uint32_t elapsed_us) {
  if (reading == kPowerOnReading) return kJump;
  use_ = agreed_us_ > 0 ? TemperatureUse::good : TemperatureUse::good_anew;
  if (agreed_us_ >= confirm_us_) follow(reading, elapsed_us);
  return Status::none;
}

bool TemperatureMonitor::is_far(Temperature reading) const {
  return distance(reading, last_) > kStepAtOnce;
}

bool TemperatureMonitor::can_be_reached(Temperature reading) const {
  const std::int64_t beyond = distance(reading, last_) - kStepAtOnce;
  return beyond * kSecondUs <= std::int64_t{kOneDegree} * since_last_us_;
}

// A new temperature is believed once a coil can have reached it, and only if the readings before it
// agree: one that leaps to and fro never is. The power-on reading counts as a jump unless the
// temperature was seen coming near it.
bool TemperatureMonitor::jumped(Temperature reading, bool confirmed) const {
  if (reading == kPowerOnReading) return distance(reading, last_) > kOneDegree;
  return is_far(reading) && !(confirmed && can_be_reached(reading));
}

bool TemperatureMonitor::is_frozen() const {
  if (unchanged_us_ < kNoiseStandsUs) return false;
  const bool shows_noise = large_steps_ >= kLargeStepsOfNoise;
  const bool was_moving = moved_ >= kMovingAtLeast && moved_ / kMoving >= resolution_;
  return shows_noise || (was_moving && unchanged_us_ >= kMovingStandsUs);
}

void TemperatureMonitor::follow(Temperature reading, std::uint32_t elapsed_us) {
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

void TemperatureMonitor::learn_step(Temperature reading) {
  const std::int32_t step = distance(reading, last_);
  if (step < resolution_) resolution_ = step;
  if (step / kLargeStep < resolution_) {
    if (large_steps_ > 0) --large_steps_;
  } else if (large_steps_ < kMostLargeSteps) {
    ++large_steps_;
  }
  moved_ = distance(reading, minute_before_);
}

}  // namespace fog
