#include <array>
#include <cstddef>
#include <cstdint>

#include "app/health.hpp"
#include "app/kept_state.hpp"
#include "app/pipeline.hpp"
#include "hal/rate_sink.hpp"
#include "platform/board.hpp"
#include "platform/instruction_counter.hpp"
#include "platform/shared/semihosting.hpp"
#include "platform/text_line.hpp"

// Cost of processing in.bin, in instructions: mean and maximum of the bytes that complete a sample
// (all stages, frames, health and self-test; without the serial line), of any kSensorFrameBytes
// consecutive bytes, the time of a sample, and of as many as the buffer of the sensor line holds.
// And of the start: self-test, table, pipeline; where there is a requests.bin, of passes of the
// main loop that answer requests of the output port.
// For QEMU's netduinoplus2 with `-icount shift=0,sleep=off` (tests/target/sample_cost.sh).
namespace fog::app {
namespace {

namespace semihosting = platform::semihosting;

class Cost {
 public:
  void add(std::uint32_t ticks) {
    total_ += ticks;
    ++count_;
    if (ticks > max_) max_ = ticks;
  }
  void report(const char* what) const {
    platform::TextLine line;
    line.text(what).text(": count ").decimal(count_).text(" mean ");
    line.decimal(count_ > 0 ? static_cast<std::uint32_t>(total_ / count_) : 0);
    hal::write_console(line.text(" max ").decimal(max_).text("\r\n").c_str());
  }

 private:
  std::uint64_t total_ = 0;
  std::uint32_t count_ = 0;
  std::uint32_t max_ = 0;
};

// Cost of any kBytes consecutive bytes.
template <std::size_t kBytes>
class CostOfBytes {
 public:
  void add(std::uint32_t ticks) {
    sum_ += ticks - latest_[place_];
    latest_[place_] = ticks;
    place_ = (place_ + 1) % kBytes;
    cost_.add(sum_);
  }
  void report(const char* what) const { cost_.report(what); }

 private:
  Cost cost_;
  std::array<std::uint32_t, kBytes> latest_{};  // a ring
  std::uint32_t sum_ = 0;
  std::size_t place_ = 0;
};

constexpr std::size_t kBufferBytes = 1024;
CostOfBytes<kBufferBytes> any_buffer;

std::array<std::uint8_t, 16384> chunk;

Cost self_tests;
std::uint32_t bytes_so_far = 0;
bool samples_alone = false;

// Time as if the bytes had come in real time; unknown with extension records between the samples.
SampleTime time_of_byte() {
  return {samples_alone, bytes_so_far / kSensorFrameBytes *
                             (model().parameters.acquisition.sample_period_us / 1000)};
}

[[gnu::noinline]] bool answer(Pipeline& pipeline, std::uint8_t byte) {
  std::array<std::uint8_t, kMaxOutputBytes> frames;
  ++bytes_so_far;
  const auto as_sent = [](const SensorSample& sample) -> const SensorSample& { return sample; };
  if (pipeline.feed(byte, frames.data(), as_sent, time_of_byte) == 0) return false;
  count_health(pipeline.last());
  const std::uint32_t start = platform::instruction_count();
  if (!keep_state_if_due()) self_test().step();
  self_tests.add(platform::instruction_count() - start);
  return true;
}

// Requests of the output port, which come after the console has said so, to the last.
void report_requests() {
  constexpr std::uint32_t kIdlePasses = 1'000'000;
  constexpr std::uint32_t kIdleInstructions = 500;
  platform::open_lines(sensor_line(), output_line());
  hal::write_console("requests, please\r\n");
  Cost requests;
  bool asked = false;
  for (std::uint32_t idle = 0; idle < kIdlePasses || !asked; ++idle) {
    const std::uint32_t start = platform::instruction_count();
    answer_requests();
    const std::uint32_t ticks = platform::instruction_count() - start;
    if (ticks < kIdleInstructions) continue;
    requests.add(ticks);
    asked = true;
    idle = 0;
  }
  requests.report("requests");
}

}  // namespace

void run() {
  platform::start_board();
  platform::start_instruction_counter();
  const std::uint32_t at_start = platform::instruction_count();
  Cost start_tests;
  self_test().run_all();
  Pipeline& product = pipeline();
  start_tests.add(platform::instruction_count() - at_start);
  samples_alone = (needs_of(model().parameters) & kAllExtensionInputs) == 0U;
  const semihosting::File input = semihosting::open("in.bin", semihosting::Mode::kRead);
  Cost samples;
  CostOfBytes<kSensorFrameBytes> any_frame;
  std::size_t size = input == semihosting::kNoFile ? 0 : chunk.size();
  while (size == chunk.size()) {
    size = semihosting::read(input, chunk.data(), chunk.size());
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint32_t start = platform::instruction_count();
      const bool answered = answer(product, chunk[i]);
      const std::uint32_t ticks = platform::instruction_count() - start;
      if (answered) samples.add(ticks);
      any_frame.add(ticks);
      any_buffer.add(ticks);
    }
  }
  samples.report("samples");
  self_tests.report("self-test");
  any_frame.report("any 16 bytes");
  any_buffer.report("any 1024 bytes");
  start_tests.report("start");
  if (semihosting::open("requests.bin", semihosting::Mode::kRead) != semihosting::kNoFile) {
    report_requests();
  }
  semihosting::exit(0);
}

}  // namespace fog::app
