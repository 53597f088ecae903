#include "core/acquisition/sample_rate_monitor.hpp"

namespace fog {
namespace {

// Over this window the few milliseconds until a sample is read do not matter.
constexpr std::int64_t kWindowUs = 10'000'000;

}  // namespace

Status SampleRateMonitor::judge(std::uint32_t elapsed, SampleTime now) {
  if (!now.known) return Status::none;
  bool counted = since_.known;
  if (counted) {
    samples_ += elapsed;
    const std::int64_t passed_us = std::int64_t{now.ms - since_.ms} * 1000;
    const std::int64_t off_us = std::int64_t{samples_} * sample_period_us_ - passed_us;
    const std::int64_t judged_us = passed_us > kWindowUs ? passed_us : kWindowUs;
    const bool off = (off_us < 0 ? -off_us : off_us) * part_ > judged_us;
    if (off) off_ = true;
    if (!off && passed_us >= kWindowUs) off_ = false;
    counted = !off && passed_us < kWindowUs;
  }
  if (!counted) {
    since_ = now;
    samples_ = 0;
  }
  return status_if(off_, Status::sample_rate);
}

}  // namespace fog
