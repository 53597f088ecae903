#pragma once

#include <cstdint>

#include "core/denoise/sample_line.hpp"

namespace fog {

/// Puts samples into a line and removes outliers of one sample, without delay. A sample that jumps
/// is withheld, and the one before is its substitute, until the next sample shows which it was. It
/// is an outlier if it differs from both neighbours, in the same direction, by more than
///   limit + |difference of the neighbours| + |difference of the two samples before|;
/// then the substitute stays. Otherwise the true sample is put back. Steps, ramps and oscillations
/// are never outliers. With limit 0 every sample passes.
class OutlierGate {
 public:
  /// `limit` in the unit of the samples, below 2^30.
  [[gnu::always_inline]] void set_limit(std::uint32_t limit) {
    limit_ = limit;
    if (!withholding()) span_ = 2 * limit + 1;
  }

  /// The sample pushed last.
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
  // The value to store for a sample that jumps, or that follows one.
  [[gnu::cold]] std::int32_t judge(SampleLine& line, std::int32_t sample);
  [[gnu::always_inline]] inline bool is_outlier(std::int32_t next, std::int32_t last) const;
  bool withholding() const { return span_ == 0; }

  std::uint32_t limit_ = 0;
  std::uint32_t span_ = 1;  // 2 limit + 1; 0 while a sample is withheld, so that no sample passes
  std::int32_t withheld_ = 0;
  std::int32_t before_last_ = 0;  // sample two before the withheld one
};

}  // namespace fog
