#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/denoise/any_denoiser.hpp"
#include "core/pipeline/compensator.hpp"
#include "core/signal/span.hpp"

namespace fogcomp::board {

/// The firmware's own pipeline with room for any model.
using HostCompensator =
    fog::Compensator<fog::kAnyModel.effects, fog::kAnyModel.expressions,
                     fog::kAnyModel.network_inputs, fog::kAnyTaps, fog::kAnyModel.levels>;

/// What a replay saw, beside the bytes.
struct ReplaySummary {
  std::uint64_t frames = 0;  ///< sensor samples accepted
  std::uint64_t output_bytes = 0;
  std::uint64_t invalid_rates = 0;    ///< samples whose undelayed rate was not valid
  std::uint64_t clamped_samples = 0;  ///< outside the trained temperature range
};

/// Bytes of the sensor stream in, the board's bytes out.
class Replay {
 public:
  /// `parameters` and the table behind them must outlive this.
  explicit Replay(const fog::ModelParameters& parameters);

  /// Feeds a piece of the stream, whose samples came at `time`; returns the bytes that it causes to
  /// be sent, valid until the next call. Without a time an outage has no more samples than sequence
  /// numbers can say, and nobody measures the sample rate.
  fog::Span<const std::uint8_t> feed(fog::Span<const std::uint8_t> bytes,
                                     fog::SampleTime time = {});

  /// The sample behind the last bytes.
  const fog::OutputSample& last() const { return compensator_->last(); }
  const ReplaySummary& summary() const { return summary_; }

 private:
  std::unique_ptr<HostCompensator> compensator_;
  std::vector<std::uint8_t> output_;
  ReplaySummary summary_;
};

}  // namespace fogcomp::board
