#include "app/health.hpp"

#include <array>

#include "app/pipeline.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/kvh_command.hpp"
#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/reset_report.hpp"
#include "platform/shared/stack.hpp"

namespace fog::app {
namespace {

HealthRecord counted;

// What is not counted is looked up when somebody asks.
HealthRecord health_now() {
  HealthRecord record = counted;
  record.image_intact = self_test().start_crc() == kIntactImage;
  record.memory_good = self_test().memory_good();
  record.model_good = model().error == ModelError::none;
  record.model = model().parameters.provenance;
  record.image_crc = self_test().start_crc();
  record.discarded_bytes = pipeline().discarded_bytes();
  record.image_passes = self_test().image_passes();
  record.memory_passes = self_test().memory_passes();
  record.stack_bytes = static_cast<std::uint16_t>(platform::stack_bytes_reserved());
  record.stack_unused_bytes = static_cast<std::uint16_t>(platform::stack_bytes_unused());
  const char* cause = describe(hal::reset_report().cause);
  for (std::size_t i = 0; i + 1 < record.reset_cause.size() && cause[i] != '\0'; ++i) {
    record.reset_cause[i] = cause[i];
  }
  return record;
}

constexpr bool kKvhCommands = (FOG_MODEL_OUTPUT_OPTIONS & kAnswersKvhCommands) != 0;

KvhSettings kvh_settings() {
  const ModelParameters& parameters = model().parameters;
  constexpr std::uint32_t kUsPerS = 1'000'000;
  const std::uint32_t period_us = parameters.acquisition.sample_period_us;
  return {(kUsPerS + period_us / 2) / period_us,
          (parameters.output_options & kRotationIsAngle) != 0U};
}

KvhCommands& kvh_commands() {
  static KvhCommands instance(kvh_settings());
  return instance;
}

void answer_kvh_command(std::uint8_t byte) {
  if constexpr (kKvhCommands) {
    std::array<std::uint8_t, KvhCommands::kMostAnswer> answer;
    const std::size_t size = kvh_commands().feed(byte, answer.data());
    if (size > 0) hal::write_output_stream(answer.data(), size);
  }
}

}  // namespace

bool sends_frames() {
  if constexpr (kKvhCommands) return !kvh_commands().configuring();
  return true;
}

void count_health(const OutputSample& sample) {
  counted.count(sample);
}

void answer_requests() {
  static HealthRequestParser parser;
  std::array<std::uint8_t, 2 * kHealthRequestBytes> bytes;
  const std::size_t size = hal::read_requests(bytes.data(), bytes.size());
  for (std::size_t i = 0; i < size; ++i) {
    answer_kvh_command(bytes[i]);
    if (!parser.feed(bytes[i])) continue;
    const HealthResponse response = encode_health_response(health_now());
    hal::write_output_stream(response.data(), response.size());
  }
}

}  // namespace fog::app
