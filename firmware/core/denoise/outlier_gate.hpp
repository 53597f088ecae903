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
  /// Below 2^30; the samples' unit.
  [[gnu::always_inline]] void set_limit(std::uint32_t limit) {
    limit_ = limit;
    if (!withholding()) span_ = 2 * limit + 1;
  }

  /// The sample that was pushed last.
  std::int32_t last(const SampleLine& line) const {
    return withholding() ? withheld_ : line.newest()[0];
  }

  [[gnu::always_inline]] void push(SampleLine& line, std::int32_t sample) {
    std::int32_t jump = 0;
    if (__builtin_sub_overflow(sample, line.newest()[0], &jump) ||
        static_cast<std::uint32_t>(jump) + limit_ >= span_) {
      sample = judge(line, sample);
    }
    line.push(sample);
  }

 private:
  // What goes into the line in place of a sample that jumps, or that follows one.
  [[gnu::cold]] std::int32_t judge(SampleLine& line, std::int32_t sample);
  [[gnu::always_inline]] inline bool is_outlier(std::int32_t next, std::int32_t last) const;
  bool withholding() const { return span_ == 0; }

  std::uint32_t limit_ = 0;
  std::uint32_t span_ = 1;  // -limit to limit; 0 while a sample is withheld: none passes
  std::int32_t withheld_ = 0;
  std::int32_t before_last_ = 0;  // two samples before the one withheld
};

}  // namespace fog
