#pragma once

#include "core/signal/inputs.hpp"
#include "core/signal/quantities.hpp"
#include "core/thermal/block_average.hpp"
#include "core/thermal/block_means.hpp"
#include "core/thermal/extension_averages.hpp"

namespace fog {

/// Gathers what the samples of a block bring into BlockMeans. Of the inputs that an image's effects
/// can need, kPossible, only those that the model needs are waited for.
template <InputMask kPossible>
class BlockCollector {
 public:
  using Extension = ExtensionAverages<kPossible & kAllExtensionInputs>;

  explicit BlockCollector(InputMask needed) : extension_(needed) {}

  void add_temperature(Temperature temperature) { temperature_.add(temperature); }
  void add_rate(Rate rate) {
    if constexpr (has(kPossible, Input::input_rate)) rate_.add(rate);
  }
  /// What came with one sample.
  void add_extension(const Extension& values) { extension_.add_means(values); }

  bool has_temperature() const { return !temperature_.empty(); }
  /// Whether every input that comes from outside and that the model needs had a good value.
  bool has_inputs() const { return extension_.has_all(); }

  /// The means; not without a temperature and the inputs. Without a single valid rate in the block,
  /// that of the last one that had some.
  BlockMeans<BoardNumbers> means(Elapsed elapsed) {
    if constexpr (has(kPossible, Input::input_rate)) {
      if (!rate_.empty()) last_rate_ = rate_.mean();
    }
    return {temperature_.mean(), last_rate_, elapsed, extension_.means()};
  }

  /// What was gathered of it so far in this block was wrong.
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
