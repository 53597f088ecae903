#include "core/denoise/outlier_gate.hpp"

namespace fog {

// Distances are up to 2^32 - 1; sums of three need 64 bits.
bool OutlierGate::is_outlier(std::int32_t before_last, std::int32_t last, std::int32_t next) const {
  if ((withheld_ > last) != (withheld_ > next)) return false;
  const std::uint64_t allowed =
      std::uint64_t{limit_} + distance(next, last) + distance(last, before_last);
  return distance(withheld_, last) > allowed && distance(withheld_, next) > allowed;
}

void OutlierGate::push_jump(SampleLine& line, std::int32_t sample) {
  if (withholding_) {
    // The newest in the line is the stand-in, the one before it what it repeats.
    withholding_ = false;
    if (!is_outlier(line.from(2)[0], line.from(1)[0], sample)) line.replace(0, withheld_);
  } else if (limit_ > 0) {
    withholding_ = true;
    withheld_ = sample;
    sample = line.from(0)[0];
  }
  line.push(sample);
}

}  // namespace fog
