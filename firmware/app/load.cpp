#include "app/load.hpp"

#ifdef FOG_MODEL_IN_SLOTS

#include "app/kept_state.hpp"
#include "app/loop_watchdog.hpp"
#include "app/pipeline.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "hal/clock.hpp"
#include "hal/model_memory.hpp"
#include "hal/rate_sink.hpp"
#include "hal/service_strap.hpp"
#include "platform/board.hpp"

namespace fog::app {
namespace {

struct ModelFlash {
  static bool erase(std::size_t slot) {
    const bool erased = hal::erase_model_memory(slot);
    start_loop_watchdog();
    return erased;
  }
  static bool program(std::size_t slot, std::size_t at, const std::uint32_t* words,
                      std::size_t count) {
    return hal::program_model_memory(slot, at, words, count);
  }
  static SlotMemory memory(std::size_t slot) {
    const hal::ModelMemory found = hal::model_memories()[slot];
    return {found.words, found.size};
  }
};

ModelFlash flash;
std::uint32_t last_message_ms = 0;  // time of the last message

SlotLoader<ModelFlash>& loader() {
  static SlotLoader<ModelFlash> instance(flash, model().load_target(), Pipeline::capacity);
  return instance;
}

}  // namespace

bool take_load_byte(std::uint8_t byte) {
  static LoadParser parser;
  if (parser.feed(byte)) {
    const LoadAnswer answer = loader().take(parser.message(), hal::service_strap_closed());
    last_message_ms = hal::milliseconds();
    if (loader().has_begun()) forget_state();
    const LoadAnswerBytes bytes = encode_load_answer(answer);
    hal::write_output_stream(bytes.data(), bytes.size());
  }
  return is_receiving_table();
}

bool is_receiving_table() {
  return loader().has_begun();
}

void end_loading() {
  constexpr std::uint32_t kTimeoutMs = 5000;  // several retries of the tool
  constexpr std::uint32_t kAnswerMs = 100;    // until the answer is sent, perhaps twice
  const std::uint32_t patience_ms = loader().has_ended() ? kAnswerMs : kTimeoutMs;
  if (hal::milliseconds() - last_message_ms >= patience_ms) platform::restart_on_request();
}

}  // namespace fog::app

#endif
