// The product's main loop with the generic image's model, while a table is loaded. This test is the
// board; its demodulator continues to send.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <deque>
#include <string>
#include <vector>

#include "board/model_slot.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/load_message.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "hal/memory_map.hpp"
#include "hal/model_memory.hpp"
#include "hal/processor.hpp"
#include "hal/rate_sink.hpp"
#include "hal/request_source.hpp"
#include "hal/reset_report.hpp"
#include "hal/sample_source.hpp"
#include "hal/service_strap.hpp"
#include "hal/watchdog.hpp"
#include "platform/board.hpp"
#include "platform/shared/stack.hpp"
#include "support/cut_flash.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::LoadAnswer;
using fog::LoadMessage;
using fog::LoadRefusal;
using fog::LoadStep;

struct EndOfTest {};
struct Restart {};

constexpr std::size_t kFrameBytes = std::tuple_size_v<fog::KvhFrame>;

struct Board {
  std::uint32_t now_ms = 0;
  std::uint32_t end_ms = 0;
  bool stalled = false;  // by an erase
  bool strap_closed = false;
  std::deque<std::uint8_t> line;
  std::deque<std::uint8_t> requests;
  std::vector<std::vector<std::uint8_t>> sent;
  std::uint32_t kicked_ms = 0;
  std::uint32_t patience_ms = 500;  // the watchdog's
  fog::test::CutFlash flash;

  void pass(std::uint32_t ms) {
    for (std::uint32_t i = 0; i < ms; ++i) {
      if (++now_ms == end_ms) throw EndOfTest();
      EXPECT_LE(now_ms - kicked_ms, patience_ms) << "the watchdog bit";
      if (now_ms % 5 != 0) continue;
      static std::uint16_t sequence = 0;
      ++sequence;
      const auto frame =
          fog::encode_sensor_frame({sequence, 700 + sequence % 7, 25 << 16, true, true});
      line.insert(line.end(), frame.begin(), frame.end());
    }
  }
};
Board board;

std::vector<std::uint8_t> sealed_image() {
  std::vector<std::uint8_t> image(1000, 0x5A);
  const auto seal = fog::seal_of(fog::crc32(image.data(), image.size(), fog::kImageCrcStart));
  image.insert(image.end(), seal.begin(), seal.end());
  return image;
}
std::array<std::uint32_t, 64> tested_memory;

std::size_t take(std::deque<std::uint8_t>& from, std::uint8_t* to, std::size_t capacity) {
  std::size_t size = 0;
  for (; size < capacity && !from.empty(); ++size) {
    to[size] = from.front();
    from.pop_front();
  }
  return size;
}

}  // namespace

namespace fog {
namespace hal {

std::uint32_t milliseconds() {
  return board.now_ms;
}
bool clock_is_accurate() {
  return true;
}
bool clock_keeps_time() {
  return true;
}
void wait_for_event() {
  board.pass(1);
}
void hold_interrupts() {}
void release_interrupts() {}
void try_another_speed() {}
void report_good_run() {}
void write_console(const char*) {}
bool service_strap_closed() {
  return board.strap_closed;
}
std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  return take(board.line, destination, capacity);
}
std::size_t read_requests(std::uint8_t* destination, std::size_t capacity) {
  return take(board.requests, destination, capacity);
}
void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  board.sent.emplace_back(bytes, bytes + size);
}
void kick_watchdog() {
  board.kicked_ms = board.now_ms;
}
void start_watchdog(std::uint32_t timeout_ms) {
  board.patience_ms = timeout_ms;
  kick_watchdog();
}
MemoryMap memory_map() {
  static const std::vector<std::uint8_t> image = sealed_image();
  return {image.data(), image.data() + image.size(), tested_memory.data(),
          tested_memory.data() + tested_memory.size(), tested_memory.data()};
}
const ResetReport& reset_report() {
  static const ResetReport report{ResetCause::power_on, {}, {}};
  return report;
}
ProcessorNumber processor_number() {
  return {1, 2, 3};
}
std::array<ModelMemory, 2> model_memories() {
  const auto memory = [](std::size_t slot) {
    return ModelMemory{board.flash.memory(slot).data, board.flash.memory(slot).size};
  };
  return {memory(0), memory(1)};
}
bool erase_model_memory(std::size_t slot) {
  board.stalled = true;  // milliseconds stand still as well
  start_watchdog(kWatchdogLoopMs);
  return board.flash.erase(slot);
}
bool program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                          std::size_t count) {
  return board.flash.program(slot, at, words, count);
}

}  // namespace hal

namespace platform {

void start_board() {}
BoardDescription describe_board() {
  return {"test", 0, "test", false, true};
}
void restart_board() {
  throw EndOfTest();
}
void restart_on_request() {
  throw Restart();
}
std::size_t stack_bytes_reserved() {
  return 0;
}
std::size_t stack_bytes_unused() {
  return 0;
}

}  // namespace platform
}  // namespace fog

namespace {

std::vector<std::uint32_t> slot_of(std::uint32_t sequence) {
  fogcomp::board::BoardSettings settings;
  settings.invalidating = fog::Status::none;
  const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
  const std::string bytes = fogcomp::board::slot_bytes(table, sequence, "test");
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

void ask_to_load(const std::vector<std::uint32_t>& slot) {
  LoadMessage message{LoadStep::begin, 0, fog::kLoadHeadWords, {}};
  std::copy_n(slot.begin(), fog::kLoadHeadWords, message.words.begin());
  std::array<std::uint8_t, fog::kMaxLoadBytes> bytes{};
  const std::size_t size = fog::encode_load_message(message, bytes.data());
  board.requests.insert(board.requests.end(), bytes.begin(),
                        bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

// What the board has sent since the last call.
struct Sent {
  std::vector<LoadAnswer> answers;
  int valid = 0;
  int silent = 0;  // not valid
};
Sent what_was_sent() {
  Sent sent;
  for (const auto& bytes : board.sent) {
    LoadAnswer answer;
    if (bytes.size() == kFrameBytes) {
      ++(bytes[28] != 0 ? sent.valid : sent.silent);
    } else if (bytes.size() == fog::kLoadAnswerBytes &&
               fog::decode_load_answer(bytes.data(), answer)) {
      sent.answers.push_back(answer);
    }
  }
  board.sent.clear();
  return sent;
}

void run_for(std::uint32_t ms) {
  board.end_ms = board.now_ms + ms;
  EXPECT_THROW(fog::app::run(), EndOfTest);
}

// One after the other: as on a board, the model is the one present at the start.
TEST(MainLoopOfTheGenericImage, StopsTheRateWhileATableIsLoadedSaysSoAndRestarts) {
  const auto first = slot_of(1);
  board.flash.program(0, 0, first.data(), first.size());
  run_for(5000);
  EXPECT_GT(what_was_sent().valid, 100) << "the denoiser is full after half of the time";

  ask_to_load(slot_of(2));
  run_for(1000);
  Sent sent = what_was_sent();
  ASSERT_EQ(sent.answers.size(), 1U);
  EXPECT_EQ(sent.answers[0].refusal, LoadRefusal::strap_open);
  EXPECT_NEAR(sent.valid, 200, 2) << "as if nothing had been asked for";
  EXPECT_LT(sent.silent, 10);

  board.strap_closed = true;
  ask_to_load(slot_of(2));
  run_for(1000);
  EXPECT_TRUE(board.stalled);
  sent = what_was_sent();
  ASSERT_EQ(sent.answers.size(), 1U);
  EXPECT_EQ(sent.answers[0].refusal, LoadRefusal::none);
  EXPECT_LE(sent.valid, 2);
  EXPECT_NEAR(sent.silent, 200, 5) << "a second of frames that are not valid";

  board.end_ms = board.now_ms + 6000;
  EXPECT_THROW(fog::app::run(), Restart) << "nobody goes on loading";
  sent = what_was_sent();
  EXPECT_EQ(sent.valid, 0);
  EXPECT_GT(sent.silent, 700);
}

}  // namespace
