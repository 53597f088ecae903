#pragma once

#include <array>
#include <cstddef>

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/block_average.hpp"
#include "core/thermal/block_means.hpp"

namespace fog {

/// Gathers what the samples of a block bring into BlockMeans. Only the inputs in kNeeded are kept;
/// an image whose effects need none has neither code nor memory for them.
template <InputMask kNeeded>
class BlockCollector {
 public:
  void add_temperature(Temperature temperature) { temperature_.add(temperature); }

  void add_rate(Rate rate) {
    if constexpr (has(kNeeded, Input::input_rate)) rate_.add(rate);
  }

  void add_extension(Input input, ExtensionValue value) {
    if constexpr (kExtension != 0U) {
      if (has(kNeeded, input)) extension_[static_cast<std::size_t>(input)].add(value);
    }
  }

  bool has_temperature() const { return !temperature_.empty(); }

  /// Whether every input that comes from outside and that the effects need had a good value.
  bool has_inputs() const {
    if constexpr (kExtension != 0U) {
      for (std::size_t i = 0; i < kExtensionInputs; ++i) {
        if (has(kNeeded, static_cast<Input>(i)) && extension_[i].empty()) return false;
      }
    }
    return true;
  }

  /// The means; not without a temperature and the inputs. Without a single valid rate in the block,
  /// that of the last one that had some.
  BlockMeans<BoardNumbers> means(Elapsed elapsed) {
    BlockMeans<BoardNumbers> block;
    block.temperature = temperature_.mean();
    block.elapsed = elapsed;
    if constexpr (has(kNeeded, Input::input_rate)) {
      if (!rate_.empty()) last_rate_ = rate_.mean();
      block.input_rate = last_rate_;
    }
    if constexpr (kExtension != 0U) {
      for (std::size_t i = 0; i < kExtensionInputs; ++i) {
        if (!extension_[i].empty()) block.extension[i] = extension_[i].mean();
      }
    }
    return block;
  }

  void clear() {
    temperature_.clear();
    rate_.clear();
    for (auto& average : extension_) average.clear();
  }

 private:
  static constexpr InputMask kExtension = kNeeded & kAllExtensionInputs;

  BlockAverage<Temperature> temperature_;
  BlockAverage<Rate> rate_;
  Rate last_rate_{};
  std::array<BlockAverage<ExtensionValue>, kExtension != 0U ? kExtensionInputs : 0> extension_;
};

}  // namespace fog
