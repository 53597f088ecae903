#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// One flag for each slot of a SampleLine: whether its sample was valid.
template <std::size_t kSlots>
class ValidityLine {
 public:
  /// Whether all samples in the line were valid: as long as valid ones follow, nothing needs to be
  /// exchanged.
  bool settled() const { return unsettled_ == 0; }

  /// Notes whether the newest sample, in slot `newest` of `length`, is valid, and tells whether the
  /// one in slot `asked` was.
  bool exchange(bool valid, std::size_t newest, std::size_t asked, std::size_t length) {
    if (!valid) {
      unsettled_ = length;
    } else if (unsettled_ > 0) {
      --unsettled_;
    }
    std::uint32_t& word = invalid_[newest / 32U];
    const std::uint32_t mask = std::uint32_t{1} << (newest % 32U);
    word = valid ? word & ~mask : word | mask;
    return ((invalid_[asked / 32U] >> (asked % 32U)) & 1U) == 0U;
  }

 private:
  std::array<std::uint32_t, kSlots / 32U + 1U> invalid_{};
  std::size_t unsettled_ = 0;  // samples until every slot has been found valid since the last fault
};

}  // namespace fog
