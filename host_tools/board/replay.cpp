#include "board/replay.hpp"

#include <array>

#include "board/host_compensator.hpp"

namespace fogcomp::board {

struct Replay::Pipeline : HostCompensator {
  using HostCompensator::HostCompensator;
};

Replay::Replay(const fog::ModelParameters& parameters)
    : pipeline_(std::make_unique<Pipeline>(parameters, fog::IntegrityToken::not_needed())) {}
Replay::~Replay() = default;

const fog::OutputSample& Replay::last() const {
  return pipeline_->last();
}

fog::Span<const std::uint8_t> Replay::feed(fog::Span<const std::uint8_t> bytes,
                                           fog::SampleTime time) {
  output_.clear();
  std::array<std::uint8_t, fog::kMaxOutputBytes> frames;
  const auto as_sent = [](const fog::SensorSample& sample) { return sample; };
  for (const std::uint8_t byte : bytes) {
    const std::size_t size = pipeline_->feed(byte, frames.data(), as_sent, [&] { return time; });
    if (size == 0) continue;
    output_.insert(output_.end(), frames.data(), frames.data() + size);
    const fog::OutputSample& sample = pipeline_->last();
    ++summary_.frames;
    if (!sample.compensated_valid()) ++summary_.invalid_rates;
    if (has_any(sample.status, fog::Status::temperature_clamped)) ++summary_.clamped_samples;
  }
  summary_.output_bytes += output_.size();
  return {output_.data(), output_.size()};
}

}  // namespace fogcomp::board
