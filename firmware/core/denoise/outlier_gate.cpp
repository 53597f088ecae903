#include "core/denoise/outlier_gate.hpp"

namespace fog {
namespace {

std::uint32_t distance(std::int32_t a, std::int32_t b) {
  const auto difference = static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b);
  return a > b ? difference : 0U - difference;
}

// Whether `rest` is more than `part`; if so, takes it off: a sum in its place could need 34 bits.
bool exceeds(std::uint32_t& rest, std::uint32_t part) {
  if (rest <= part) return false;
  rest -= part;
  return true;
}

}  // namespace

bool OutlierGate::is_outlier(std::int32_t next, std::int32_t last) const {
  if ((withheld_ > last) != (withheld_ > next)) return false;
  const std::uint32_t off_last = distance(withheld_, last);
  const std::uint32_t off_next = distance(withheld_, next);
  std::uint32_t off = off_last < off_next ? off_last : off_next;
  return exceeds(off, limit_) && exceeds(off, distance(next, last)) &&
         exceeds(off, distance(last, before_last_));
}

std::int32_t OutlierGate::judge(SampleLine& line, std::int32_t sample) {
  const std::int32_t newest = line.newest()[0];
  if (withholding()) {
    // The newest in the line is the stand-in, which repeats the one before.
    if (!is_outlier(sample, newest)) line.replace_newest(withheld_);
    span_ = 2 * limit_ + 1;
    return sample;
  }
  if (limit_ == 0) return sample;
  span_ = 0;
  withheld_ = sample;
  before_last_ = line.newest()[1];
  return newest;
}

}  // namespace fog
