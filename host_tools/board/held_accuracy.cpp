#include "board/table_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "board/delays.hpp"
#include "model/drift_model.hpp"

namespace fogcomp::board {
namespace {

constexpr double kSinceStartS = 3600;
constexpr double kSlowestDegcPerMin = 0.05;  // slower ones do not change the result
constexpr std::uint32_t kLongestSoakBlocks = 3600;

constexpr std::uint32_t kLeastPart = 50;
constexpr double kPartSpan = 4;  // from the least part to the largest

/// Drift of every block on a way up and down through the trained range.
class RoundTrip {
 public:
  /// A block lasts `block_s`, and the model takes it for `believed_s`. `inputs_at`: where in their
  /// trained ranges those without thermal mass stand, 0 to 1.
  RoundTrip(const model::Model& model, double block_s, double believed_s, double inputs_at)
      : model_(model, believed_s) {
    const model::Range& rate = *model.rate_range_degc_per_min;
    const double fastest = std::max({std::abs(rate.min), std::abs(rate.max), kSlowestDegcPerMin});
    const double step_degc = fastest * block_s / 60;
    const auto soak_blocks =
        std::min(static_cast<std::uint32_t>(std::ceil(settling_time_s(model) / block_s)),
                 kLongestSoakBlocks);
    block_.temperature = model.min_degc;
    block_.elapsed = kSinceStartS / block_s;
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      const auto& input = model.input_ranges[i];
      if (!input) continue;
      const double at = fog::extension_input(i) == fog::Input::temperature2 ? 0.5 : inputs_at;
      block_.extension[i] = input->range.min + at * (input->range.max - input->range.min);
    }
    model_.start(block_);
    for (const double end : {model.max_degc, model.min_degc}) {
      while (block_.temperature != end) {
        const double left = end - block_.temperature;
        block_.temperature += std::clamp(left, -step_degc, step_degc);
        step();
      }
      for (std::uint32_t i = 0; i < soak_blocks; ++i) step();
    }
  }

  /// Between the drift of a block and that of `other`, which goes the same way, `blocks` before it.
  double largest_difference_dph(const RoundTrip& other, std::size_t blocks) const {
    double largest = 0;
    for (std::size_t i = blocks; i < drift_dph_.size(); ++i) {
      largest = std::max(largest, std::abs(drift_dph_[i] - other.drift_dph_[i - blocks]));
    }
    return largest;
  }

 private:
  void step() {
    model_.step(block_);
    drift_dph_.push_back(model_.drift_dph());
  }

  model::RealDriftModel model_;
  model::RealBlock block_;
  std::vector<double> drift_dph_;
};

}  // namespace

std::uint32_t accurate_hold_blocks(const model::Model& model, double block_s,
                                   std::uint32_t hold_blocks) {
  if (!model.rate_range_degc_per_min) return hold_blocks;
  // A field or a supply may within a block be anywhere that it has been.
  const RoundTrip from(model, block_s, block_s, 0);
  const RoundTrip to(model, block_s, block_s, 1);
  std::uint32_t blocks = 0;
  while (blocks < hold_blocks &&
         to.largest_difference_dph(from, blocks + 1) <= model.residual_rms_dph) {
    ++blocks;
  }
  return blocks;
}

std::uint32_t sample_rate_part(const model::Model& model, double block_s) {
  if (!model.rate_range_degc_per_min) return kLeastPart;
  const double slow_s = block_s * (1 + 1.0 / kLeastPart);
  const RoundTrip right(model, slow_s, slow_s, 0.5);
  const RoundTrip believed(model, slow_s, block_s, 0.5);
  const double error = right.largest_difference_dph(believed, 0);
  if (error <= model.residual_rms_dph) return kLeastPart;
  const double parts = std::min(error / model.residual_rms_dph, kPartSpan);
  return static_cast<std::uint32_t>(std::ceil(kLeastPart * parts));
}

}  // namespace fogcomp::board
