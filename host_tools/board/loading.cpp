#include "board/loading.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include "board/board_query.hpp"
#include "board/board_texts.hpp"
#include "board/table_files.hpp"
#include "core/frames/load_message.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

using fog::LoadAnswer;
using fog::LoadMessage;
using fog::LoadRefusal;
using fog::LoadStep;
using Words = std::vector<std::uint32_t>;

constexpr double kPatienceS = 3;
constexpr double kAnswerS = 0.5;
constexpr double kEraseS = 4;        // erases a slot of the slowest flash, and answers
constexpr int kTriesOfRestart = 14;  // of 0.75 s each

fog::LoadTarget target_of(const fog::SlotsRecord& slots, const fog::HealthRecord& health) {
  fog::LoadTarget target;
  const auto* const processor = &health.words[static_cast<std::size_t>(fog::HealthWord::processor)];
  std::copy_n(processor, target.processor.size(), target.processor.begin());
  if (slots.used >= slots.slots.size()) return target;
  target.used = slots.used;
  target.has_owner = true;
  target.sequence = slots.slots[slots.used].sequence;
  target.serial = slots.slots[slots.used].serial;
  return target;
}

// Of both slots, even unusable ones.
std::uint32_t newest_sequence(const fog::SlotsRecord& slots) {
  std::uint32_t newest = 0;
  for (const fog::SlotRecord& slot : slots.slots) {
    const bool is_newer = static_cast<std::int32_t>(slot.sequence - newest) > 0;
    if (slot.table != 0 && (newest == 0 || is_newer)) newest = slot.sequence;
  }
  return newest;
}

Words words_of(const std::string& bytes) {
  Words words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

std::string gyro_at(const std::uint32_t* serial) {
  const std::string text = serial_text(serial);
  return text.empty() ? "no gyro (without a serial number)" : "gyro " + displayable(text);
}

// Text for a refusal because of the table.
std::string reason(LoadRefusal refusal, const Words& slot, const fog::LoadTarget& target) {
  switch (refusal) {
    case LoadRefusal::other_board: {
      const auto* const bound = &slot[fog::kSlotHeaderWords + fog::kProcessorAt];
      return "is bound to processor " + processor_text({bound[0], bound[1], bound[2]}) +
             "; this board has " + processor_text(target.processor);
    }
    case LoadRefusal::other_gyro:
      return "is of " + gyro_at(&slot[fog::kSlotHeaderWords + fog::kIdentityAt]) +
             ", and the board's table of " + gyro_at(target.serial.data()) +
             "; --another-gyro if the board has been given to it";
    case LoadRefusal::no_owner:
      return "would be the board's first one and bind it to its gyro; say which that is: --serial";
    case LoadRefusal::other_layout:
      return "has another layout than the board's firmware; export it with the fogcomp of that";
    case LoadRefusal::not_in_image:
      return "the board's image has no room for it (firmware/SPEC.md, Model slots)";
    case LoadRefusal::frames_too_long:
      return "its frames take longer on the output line than a sample period";
    case LoadRefusal::sample_too_dear:
      return "a sample may take longer to compute than half a sample period; export it again";
    case LoadRefusal::not_newer:
      return "the board has a newer one by now; try again";
    default:
      return "is no good table; export it again";
  }
}

[[noreturn]] void refuse(LoadRefusal refusal, const Words& slot, const fog::LoadTarget& target,
                         const LoadRequest& request) {
  switch (refusal) {
    case LoadRefusal::strap_open:
      throw InputError(request.port,
                       "the board's service strap is open; close it (firmware/README.md, Wire)");
    case LoadRefusal::flash_failed:
      throw InputError(request.port,
                       "the board's flash does not hold what is written to it; the "
                       "table in use is as it was");
    case LoadRefusal::not_expected:
      throw InputError(request.port, "the board has lost a part of the table; try again");
    default:
      throw InputError(request.file, reason(refusal, slot, target));
  }
}

/// Sends one message and returns its answer; nothing if none comes.
std::optional<LoadAnswer> send(BoardPort& port, const LoadMessage& message) {
  std::vector<std::uint8_t> bytes(fog::kMaxLoadBytes);
  bytes.resize(fog::encode_load_message(message, bytes.data()));
  const bool erases = message.step == LoadStep::begin;
  LoadAnswer answer;
  const auto decode = [&](const std::uint8_t* received) {
    return fog::decode_load_answer(received, answer) && answer.step == message.step &&
           (message.step != LoadStep::block || answer.refusal != LoadRefusal::none ||
            answer.next == message.at + message.size);
  };
  if (BoardQuery(port).ask(bytes, fog::kLoadAnswerBytes, erases ? 2 * kEraseS : kPatienceS,
                           erases ? kEraseS : kAnswerS, decode)) {
    return answer;
  }
  return {};
}

LoadMessage message_of(LoadStep step, std::uint32_t argument, const Words& slot, std::size_t at,
                       std::size_t size) {
  LoadMessage message{step, argument, static_cast<std::uint32_t>(size), {}};
  std::copy_n(slot.begin() + static_cast<std::ptrdiff_t>(at), size, message.words.begin());
  return message;
}

// All messages but `end`.
LoadRefusal send_words(BoardPort& port, const Words& slot, std::uint32_t options,
                       const LoadRequest& request) {
  LoadMessage message = message_of(LoadStep::begin, options, slot, 0, fog::kLoadHeadWords);
  for (std::size_t at = 0;;) {
    const std::optional<LoadAnswer> answer = send(port, message);
    if (!answer) {
      throw InputError(request.port,
                       "no answer while the table was loaded; the table in use is as "
                       "it was; try again");
    }
    at += message.size;
    if (answer->refusal != LoadRefusal::none || at == slot.size()) return answer->refusal;
    message = message_of(LoadStep::block, static_cast<std::uint32_t>(at), slot, at,
                         std::min(fog::kMaxLoadWords, slot.size() - at));
  }
}

// A board whose answer was lost has restarted in the meantime and expects no `end`: its slots show
// the result.
LoadRefusal send_end(BoardPort& port) {
  const std::optional<LoadAnswer> answer = send(port, {LoadStep::end, 0, 0, {}});
  const bool may_have_restarted = !answer || answer->refusal == LoadRefusal::not_expected;
  return may_have_restarted ? LoadRefusal::none : answer->refusal;
}

LoadedTable await_restart(BoardPort& port, std::size_t slot, std::uint32_t table_crc,
                          const LoadRequest& request) {
  for (int i = 0; i < kTriesOfRestart; ++i) {
    const auto slots = query_slots(port);
    if (!slots || slots->used != slot) continue;
    const fog::SlotRecord& record = slots->slots[slot];
    if (record.table == table_crc) return {slot, record};
  }
  throw InputError(request.port,
                   "the board has the table, but does not say that it uses it; ask "
                   "fogcomp health");
}

}  // namespace

LoadedTable load_table(BoardPort& port, const BoardTable& table, const LoadRequest& request) {
  const fog::HealthRecord health = query_health(port, request.port, kPatienceS);
  const auto slots = query_slots(port, kPatienceS);
  if (!slots) {
    throw InputError(request.port,
                     "this board's image has its model in it; flash the generic "
                     "image (firmware/README.md) to load one");
  }
  const fog::LoadTarget target = target_of(*slots, health);
  const Words slot = words_of(slot_bytes(table, newest_sequence(*slots) + 1, request.file));
  const std::uint32_t options = (request.another_gyro ? fog::kMayBeAnotherGyro : 0) |
                                (request.serial_given ? fog::kMayBeFirst : 0);
  LoadRefusal refusal = fog::refusal_of_head(slot.data(), target, options);
  if (refusal == LoadRefusal::none) refusal = send_words(port, slot, options, request);
  if (refusal == LoadRefusal::none) refusal = send_end(port);
  if (refusal != LoadRefusal::none) refuse(refusal, slot, target, request);
  port.set_line(fog::SerialLine(static_cast<std::uint32_t>(*(table.words.end() - 2))));
  return await_restart(port, target.slot(), static_cast<std::uint32_t>(table.words.back()),
                       request);
}

}  // namespace fogcomp::board
