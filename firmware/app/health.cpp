#include "app/health.hpp"

#include <array>

#include "app/load.hpp"
#include "app/pipeline.hpp"
#include "build_identity.h"
#include "core/frames/health_request.hpp"
#include "core/frames/kvh_bit.hpp"
#include "core/frames/kvh_command.hpp"
#include "hal/clock.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/reset_report.hpp"
#include "platform/shared/stack.hpp"

namespace fog::app {
namespace {

SampleCounts counted;

// HealthWord::rate_delay.
std::uint32_t delay_and_filter() {
  const std::uint32_t delay = pipeline().rate_delay();
  const Span<const std::int32_t> low = model().parameters.denoise.low();
  constexpr std::uint32_t kUpperHalf = 0xFFFF0000U;
  return delay == 0 ? 0 : delay | (static_cast<std::uint32_t>(low[low.size / 2]) & kUpperHalf);
}

// Reads the values that are not counted; in the order of the words.
HealthRecord health_now() {
  const hal::ProcessorNumber processor = hal::processor_number();
  const SelfTest& test = self_test();
  const Model& used = model();
  static_assert(processor.size() == 3);
  static_assert(HealthWord::serial == static_cast<HealthWord>(18));
  HealthRecord record{
      test.start_crc() == kIntactImage,
      test.memory_good(),
      static_cast<std::uint8_t>(used.error),
      {used.parameters.provenance, seal_of_image(), counted.samples, counted.invalid_rates,
       counted.sequence_gaps, static_cast<std::uint32_t>(counted.status_last),
       static_cast<std::uint32_t>(counted.status_seen), pipeline().discarded_bytes(),
       test.image_passes(), test.memory_passes(),
       static_cast<std::uint32_t>(platform::stack_bytes_reserved() | platform::stack_bytes_unused()
                                                                         << 16U),
       delay_and_filter(), used.parameters.acquisition.sample_period_us, FOG_BUILD_VERSION_NUMBER,
       FOG_BUILD_SOURCES, processor[0], processor[1], processor[2]},
      {}};
  if (used.error == ModelError::none) {
    __builtin_memcpy(&record[HealthWord::serial], used.serial(), 4 * kSerialWords);
  }
  const char* cause = describe(hal::reset_report().cause);
  for (std::size_t i = 0; i + 1 < record.reset_cause.size() && cause[i] != '\0'; ++i) {
    record.reset_cause[i] = cause[i];
  }
  return record;
}

// A loaded model selects the commands itself.
[[maybe_unused]] bool answers_kvh_commands() {
  return !ModelTable::is_loaded || (model().parameters.output_options & kAnswersKvhCommands) != 0U;
}

KvhSettings kvh_settings() {
  const ModelParameters& parameters = model().parameters;
  constexpr std::uint32_t kUsPerS = 1'000'000;
  const std::uint32_t period_us = parameters.acquisition.sample_period_us;
  return {(kUsPerS + period_us / 2) / period_us,
          (parameters.output_options & kRotationIsAngle) != 0U, output_line().baud()};
}

[[maybe_unused]] KvhCommands& kvh_commands() {
  static KvhCommands instance(kvh_settings());
  return instance;
}

// A user who is cut off in the configuration mode must not leave the board silent.
constexpr std::uint32_t kConfigurationMs = 10'000;
[[maybe_unused]] std::uint32_t last_command_ms = 0;

void end_configuration() {
  if constexpr (kKvhCommands) {
    if (hal::milliseconds() - last_command_ms < kConfigurationMs) return;
    if (answers_kvh_commands()) kvh_commands().leave_configuration();
  }
}

// What the tests have found: at the start, and with the last sample.
Status test_status() {
  const SelfTest& test = self_test();
  const bool good = test.start_crc() == kIntactImage && test.memory_good();
  return pipeline().last().status | status_if(!good, Status::self_test_failed) |
         status_if(model().error != ModelError::none, Status::model_refused);
}

void answer_kvh_command(std::uint8_t byte) {
  if constexpr (kKvhCommands) {
    if (!answers_kvh_commands()) return;
    last_command_ms = hal::milliseconds();
    std::array<std::uint8_t, KvhCommands::kMaxAnswer> answer;
    const std::size_t size = kvh_commands().feed(byte, answer.data(), test_status());
    if (size > 0) hal::write_output_stream(answer.data(), size);
  }
}

// A template, so that an image with a built-in table has none of this code. Not inline, like the
// health record below.
template <class Table>
[[gnu::noinline]] void send_slots(const Table& table) {
  const SlotsResponse response = encode_slots_response(table.slots());
  hal::write_output_stream(response.data(), response.size());
}

template <class Table>
void answer_slots_request(std::uint8_t byte, const Table& table) {
  if constexpr (Table::is_loaded) {
    static RequestParser<kSlotsRequest> parser;
    if (parser.feed(byte)) send_slots(table);
  }
}

// Not inline: its record and response must not be on the stack while a table is checked.
[[gnu::noinline]] void answer_health_request() {
  const HealthResponse response = encode_health_response(health_now());
  hal::write_output_stream(response.data(), response.size());
}

}  // namespace

bool sends_frames() {
  if constexpr (kKvhCommands) return !answers_kvh_commands() || !kvh_commands().configuring();
  return true;
}

void count_health(const OutputSample& sample) {
  counted.count(sample);
}

void report_start_tests() {
  if (!answers_kvh_commands()) return;
  std::array<std::uint8_t, kKvhExtendedBitBytes> message;
  const std::size_t size = encode_kvh_bit(test_status(), false, message.data());
  hal::write_output_stream(message.data(), size);
}

void answer_requests() {
  static HealthRequestParser parser;
  std::array<std::uint8_t, 2 * kHealthRequestBytes> bytes;
  const std::size_t size = hal::read_requests(bytes.data(), bytes.size());
  for (std::size_t i = 0; i < size; ++i) {
    if constexpr (ModelTable::is_loaded) {
      if (take_load_byte(bytes[i])) continue;
    }
    answer_kvh_command(bytes[i]);
    if constexpr (ModelTable::is_loaded) answer_slots_request<ModelTable>(bytes[i], model());
    if (parser.feed(bytes[i])) answer_health_request();
  }
  end_configuration();
  if (is_loading()) end_loading();
}

}  // namespace fog::app
