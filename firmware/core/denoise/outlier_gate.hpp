#pragma once

#include <cstddef>
#include <cstdint>

#include "core/denoise/sample_line.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/fixed_point/shift.hpp"

namespace fog {

/// Puts samples into a line and removes outliers of one sample, without delay. A sample that jumps
/// is withheld, and the one before is its substitute, until the next sample shows which it was. It
/// is an outlier if it differs from both neighbours, in the same direction, by more than
///   limit + |difference of the neighbours| + |difference of the two samples before|;
/// then the substitute stays. Otherwise the true sample is put back. Steps, ramps and oscillations
/// are never outliers. With limit 0 every sample passes.
///
/// What it removes may have been a rotation. So it corrects the validity of the sample before the
/// one pushed last, which its owner keeps in it, and asks to be watched.
class OutlierGate {
 public:
  /// Whether the owner has to look at the validities with the next push: for `pushes` of them, and
  /// while a sample is withheld.
  bool watched() const { return watched_ > 0; }
  void watch(std::size_t pushes) { watched_ = pushes; }
  /// To be called before each push that is watched, or followed by watch().
  void count_watched() { --watched_; }

  /// Validity of the sample pushed last; the next push makes that of an outlier false.
  bool valid() const { return valid_; }
  void set_valid(bool valid) { valid_ = valid; }

  static constexpr std::uint32_t kMaxLimit = power_of_two<std::uint32_t>(30) - 1;
  // push(): the largest jump of either sign, which may be a saturated one, is above every limit.
  static_assert(INT32_MAX + kMaxLimit >= 2 * kMaxLimit + 1);
  static_assert(power_of_two<std::uint32_t>(31) + kMaxLimit >= 2 * kMaxLimit + 1);

  /// `limit` in the unit of the samples, up to kMaxLimit.
  [[gnu::always_inline]] void set_limit(std::uint32_t limit) {
    limit_ = limit;
    if (!withholding()) span_ = 2 * limit + 1;
  }

  /// The sample pushed last.
  std::int32_t last(const SampleLine& line) const {
    return withholding() ? withheld_ : line.newest()[0];
  }

  [[gnu::always_inline]] void push(SampleLine& line, std::int32_t sample) {
    const std::int32_t jump = saturating_difference(sample, line.newest()[0]);
    if (static_cast<std::uint32_t>(jump) + limit_ >= span_) {
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
  std::size_t watched_ = 0;
  bool valid_ = true;
};

}  // namespace fog
