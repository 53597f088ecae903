#include "core/denoise/outlier_gate.hpp"

namespace fog {
namespace {

// upper - lower for upper >= lower; needs 32 bits.
std::uint32_t distance(std::int32_t upper, std::int32_t lower) {
  return static_cast<std::uint32_t>(upper) - static_cast<std::uint32_t>(lower);
}

// Whether `rest` exceeds `part`; if so, subtracts it. The sum of all parts could need 34 bits.
bool exceeds(std::uint32_t& rest, std::uint32_t part) {
  if (rest <= part) return false;
  rest -= part;
  return true;
}

}  // namespace

bool OutlierGate::is_outlier(std::int32_t next, std::int32_t last) const {
  std::int32_t lower = next;
  std::int32_t upper = last;
  if (next > last) {
    lower = last;
    upper = next;
  }
  std::uint32_t off = 0;
  if (withheld_ > upper) {
    off = distance(withheld_, upper);
  } else if (withheld_ < lower) {
    off = distance(lower, withheld_);
  }
  if (!exceeds(off, limit_) || !exceeds(off, distance(upper, lower))) return false;
  return exceeds(off,
                 last > before_last_ ? distance(last, before_last_) : distance(before_last_, last));
}

std::int32_t OutlierGate::judge(SampleLine& line, std::int32_t sample) {
  const std::int32_t newest = line.newest()[0];
  if (withholding()) {
    // The newest value in the line is the substitute, a copy of the one before.
    if (is_outlier(sample, newest)) {
      valid_ = false;
    } else {
      line.replace_newest(withheld_);
    }
    span_ = 2 * limit_ + 1;
    return sample;
  }
  if (limit_ == 0) return sample;
  if (watched_ == 0) watched_ = 1;
  span_ = 0;
  withheld_ = sample;
  before_last_ = line.newest()[1];
  return newest;
}

}  // namespace fog
