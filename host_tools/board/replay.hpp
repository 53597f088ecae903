#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/acquisition/sample_time.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "core/signal/output_sample.hpp"
#include "core/signal/span.hpp"

namespace fogcomp::board {

/// Statistics of a replay.
struct ReplaySummary {
  std::uint64_t frames = 0;  ///< sensor samples accepted
  std::uint64_t output_bytes = 0;
  std::uint64_t invalid_rates = 0;    ///< samples whose undelayed rate was not valid
  std::uint64_t clamped_samples = 0;  ///< outside the trained temperature range
};

/// Passes bytes of the sensor stream to the pipeline and returns the board's output.
class Replay {
 public:
  /// `parameters` and their table must outlive this object.
  explicit Replay(const fog::ModelParameters& parameters);
  ~Replay();

  /// Feeds a piece of the stream, whose samples arrived at `time`; returns the resulting output,
  /// valid until the next call. Without a time the length of a gap follows from the sequence
  /// numbers alone, and the sample rate is not checked.
  fog::Span<const std::uint8_t> feed(fog::Span<const std::uint8_t> bytes,
                                     fog::SampleTime time = {});

  /// The sample of the last output.
  const fog::OutputSample& last() const;
  const ReplaySummary& summary() const { return summary_; }

 private:
  struct Pipeline;  // here it would be compiled by everyone who replays
  std::unique_ptr<Pipeline> pipeline_;
  std::vector<std::uint8_t> output_;
  ReplaySummary summary_;
};

}  // namespace fogcomp::board
