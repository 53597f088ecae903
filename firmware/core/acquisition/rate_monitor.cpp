#include "core/acquisition/rate_monitor.hpp"

namespace fog {
namespace {

// Out of range is set at 97.5 % of full scale and cleared after 50 ms below 92.5 %. Near full scale
// a demodulator folds or clips; the hysteresis keeps the flag from flickering.
constexpr std::int32_t kSetFortieths = 39;
constexpr std::int32_t kClearFortieths = 37;
constexpr std::uint32_t kClearUs = 50'000;

// Upper limit of the counts of elapsed samples; times the largest step it fits 64 bits.
constexpr std::uint32_t kMaxElapsedSamples = 1U << 30U;
static_assert(kMaxElapsedSamples <= INT64_MAX / RateMonitor::kMaxStep);
static_assert(RateMonitor::kMaxElapsed <= INT64_MAX / RateMonitor::kMaxStep);

// range * fortieths / 40, rounded down, without 64-bit arithmetic.
Rate share(Rate range, std::int32_t fortieths) {
  return Rate::from_raw(range.raw() / 40 * fortieths + range.raw() % 40 * fortieths / 40);
}

std::int64_t magnitude(std::int64_t value) {
  return value < 0 ? -value : value;
}

std::int64_t distance(Rate a, Rate b) {
  return magnitude(std::int64_t{a.raw()} - std::int64_t{b.raw()});
}

std::uint32_t sum_of_samples(std::uint32_t a, std::uint32_t b) {
  return b < kMaxElapsedSamples - a ? a + b : kMaxElapsedSamples;
}

}  // namespace

RateMonitor::RateMonitor(const RateLimits& limits, std::uint32_t sample_period_us)
    : range_(limits.range),
      set_at_(share(range_, kSetFortieths)),
      clear_at_(share(range_, kClearFortieths)),
      clear_samples_((kClearUs + sample_period_us - 1) / sample_period_us),
      inside_samples_(clear_samples_),
      max_step_(shift_left(std::int64_t{limits.step.raw()},
                           Rate::fractional_bits - RateStep::fractional_bits)) {}

Status RateMonitor::judge(Rate measured, bool trusted, std::uint32_t elapsed) {
  const bool out_of_range = judge_range(measured, elapsed);
  since_accepted_ = sum_of_samples(since_accepted_, elapsed);
  unseen_samples_ = sum_of_samples(unseen_samples_, elapsed);
  if (max_step_ * unseen_samples_ >= range_.raw()) may_have_reversed_ = true;
  const bool jump = jumped(measured, elapsed);
  last_ = measured;
  if (trusted) {
    unseen_samples_ = 0;
    if (!jump && magnitude(measured.raw()) < set_at_.raw()) {
      has_accepted_ = true;
      accepted_ = measured;
      since_accepted_ = 0;
      mirrored_ = may_have_reversed_ = false;
    }
  }
  return status_if(out_of_range, Status::rate_out_of_range) | status_if(jump, Status::rate_jump);
}

bool RateMonitor::judge_range(Rate measured, std::uint32_t elapsed) {
  const std::int64_t size = magnitude(measured.raw());
  if (size >= set_at_.raw()) {
    out_of_range_ = true;
    inside_samples_ = 0;
  } else if (size > clear_at_.raw()) {
    inside_samples_ = 0;
  } else if (out_of_range_) {
    inside_samples_ =
        elapsed < clear_samples_ - inside_samples_ ? inside_samples_ + elapsed : clear_samples_;
    out_of_range_ = inside_samples_ < clear_samples_;
  }
  return out_of_range_;
}

// A spike is refused. The good sample after it is accepted, because it is near the last accepted
// one. A new steady rate is accepted as soon as the gyro can have reached it and two samples in a
// row agree; so an alternating rate is never accepted. A change by more than the range between two
// consecutive samples is a fold: the rate left the range at one end and reappeared at the other. It
// is right again once it has folded back. So is one that leaps to its mirror image: the sign has
// flipped. Where one step is enough to turn the other way nobody can tell.
bool RateMonitor::jumped(Rate measured, std::uint32_t elapsed) {
  const std::int64_t step = distance(measured, accepted_);
  if (!has_accepted_ || step <= max_step_) return false;
  const std::int64_t raw = measured.raw();
  if (2 * magnitude(raw) <= max_step_) mirrored_ = false;
  const bool leaps =
      step > max_step_ * since_accepted_ || distance(measured, last_) > max_step_ * elapsed;
  if (leaps && magnitude(raw + accepted_.raw()) <= max_step_) mirrored_ = true;
  return leaps || ((step > range_.raw() || mirrored_) && !may_have_reversed_);
}

}  // namespace fog
