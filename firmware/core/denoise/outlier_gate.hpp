#pragma once

#include <cstdint>

#include "core/denoise/sample_line.hpp"

namespace fog {

/// Takes samples into a line and keeps outliers of one sample out of it, without delay: a sample
/// that jumps is withheld, the one before standing in for it, until the next one tells. It is an
/// outlier if it stands off both neighbours to the same side by more than
///   limit + |difference of the neighbours| + |difference of the two samples before|;
/// then the stand-in stays. Otherwise the line gets the true sample back. Steps, ramps and
/// oscillations are never outliers. Limit 0: every sample passes.
class OutlierGate {
 public:
  /// Below 2^31; the samples' unit.
  void set_limit(std::uint32_t limit) { limit_ = limit; }

  void push(SampleLine& line, std::int32_t sample) {
    if (!withholding_ && distance(sample, line.from(0)[0]) <= limit_) {
      line.push(sample);
    } else {
      push_jump(line, sample);
    }
  }

 private:
  static constexpr std::uint32_t distance(std::int32_t a, std::int32_t b) {
    const auto difference = static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b);
    return a > b ? difference : 0U - difference;
  }
  void push_jump(SampleLine& line, std::int32_t sample);
  bool is_outlier(std::int32_t before_last, std::int32_t last, std::int32_t next) const;

  std::uint32_t limit_ = 0;
  std::int32_t withheld_ = 0;
  bool withholding_ = false;
};

}  // namespace fog
