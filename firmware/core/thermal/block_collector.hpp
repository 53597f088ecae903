#pragma once

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/block_average.hpp"
#include "core/thermal/block_means.hpp"
#include "core/thermal/extension_averages.hpp"

namespace fog {

/// Averages the samples of a block to BlockMeans. Of the inputs that the image supports
/// (kPossible), only those that the model needs are required.
template <InputMask kPossible>
class BlockCollector {
 public:
  using Extension = ExtensionAverages<kPossible & kAllExtensionInputs>;

  explicit BlockCollector(InputMask needed) : extension_(needed) {}

  void add_temperature(Temperature temperature) { temperature_.add(temperature); }
  void add_rate(Rate rate) {
    if constexpr (has(kPossible, Input::input_rate)) rate_.add(rate);
  }
  /// Adds the extension values that belong to one sample.
  void add_extension(const Extension& values) { extension_.add_means(values); }

  bool has_temperature() const { return !temperature_.empty(); }
  /// Whether every extension input that the model needs had a good value.
  bool has_inputs() const { return extension_.has_all(); }

  /// The means; requires a temperature and all needed inputs. If no rate in the block was valid,
  /// the mean of the last block with valid rates is used.
  BlockMeans<BoardNumbers> means(Elapsed elapsed) {
    if constexpr (has(kPossible, Input::input_rate)) {
      if (!rate_.empty()) last_rate_ = rate_.mean();
    }
    return {temperature_.mean(), last_rate_, elapsed, extension_.means()};
  }

  /// Discards the temperatures of this block: they were wrong.
  void forget_temperature() { temperature_.clear(); }
  void forget(Input input) { extension_.forget(input); }

  void clear() {
    temperature_.clear();
    rate_.clear();
    extension_.clear();
  }

 private:
  BlockAverage<Temperature> temperature_;
  BlockAverage<Rate> rate_;
  Rate last_rate_{};
  Extension extension_;
};

}  // namespace fog
