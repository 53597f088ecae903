#pragma once

#include <array>
#include <cstddef>

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/block_average.hpp"

namespace fog {

/// Means of the extension inputs that a model needs; kPossible are those that the image supports.
/// Other inputs are not stored; an empty kPossible takes neither code nor memory.
template <InputMask kPossible>
class ExtensionAverages {
 public:
  using Means = std::array<ExtensionValue, kExtensionInputs>;

  explicit ExtensionAverages(InputMask needed) : needed_(needed) {}

  void add(Input input, ExtensionValue value) {
    if (has(needed_, input)) averages_[extension_number(input)].add(value);
  }

  /// Whether every needed input has a value.
  bool has_all() const {
    for (std::size_t i = 0; i < kExtensionInputs; ++i) {
      if (has(needed_, extension_input(i)) && averages_[i].empty()) return false;
    }
    return true;
  }

  /// 0 where there is no value.
  Means means() const {
    Means means{};
    for (std::size_t i = 0; i < kExtensionInputs; ++i) {
      if (!averages_[i].empty()) means[i] = averages_[i].mean();
    }
    return means;
  }

  /// Adds the means of `other` as one value each.
  void add_means(const ExtensionAverages& other) {
    for (std::size_t i = 0; i < kExtensionInputs; ++i) {
      if (!other.averages_[i].empty()) averages_[i].add(other.averages_[i].mean());
    }
  }

  /// Discards the values of an input: they were wrong.
  void forget(Input input) { averages_[extension_number(input)].clear(); }
  void clear() { averages_ = {}; }

 private:
  InputMask needed_;
  std::array<BlockAverage<ExtensionValue>, kExtensionInputs> averages_{};
};

template <>
class ExtensionAverages<0> {
 public:
  using Means = std::array<ExtensionValue, kExtensionInputs>;

  explicit ExtensionAverages(InputMask /*needed*/) {}

  void add(Input /*input*/, ExtensionValue /*value*/) {}
  bool has_all() const { return true; }
  Means means() const { return {}; }
  void add_means(const ExtensionAverages& /*other*/) {}
  void forget(Input /*input*/) {}
  void clear() {}
};

}  // namespace fog
