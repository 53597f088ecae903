// A table that comes in over the board's command port.
#include <algorithm>

#include "core/bytes/byte_order.hpp"
#include "core/frames/load_message.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "fuzzing.hpp"
#include "support/cut_flash.hpp"

using fog::test::promise;

namespace {

// As messages, and again with the CRC that chance would hardly meet.
void load(const std::uint8_t* data, std::size_t size) {
  static fog::test::CutFlash flash;
  const fog::LoadTarget target{0, 1, true, {}, {}};
  fog::SlotLoader<fog::test::CutFlash> loader(flash, target, fog::kGenericImage);
  fog::LoadParser parser;
  const auto feed = [&](std::uint8_t byte) {
    if (!parser.feed(byte)) return;
    promise(parser.message().size <= fog::kMaxLoadWords, "no message is longer than any");
    loader.take(parser.message(), true);
  };
  for (std::size_t i = 0; i < size; ++i) feed(data[i]);
  std::array<std::uint8_t, fog::kMaxLoadBytes> sealed;
  for (std::size_t at = 0; at + 8 <= size;) {
    fog::LoadMessage message{static_cast<fog::LoadStep>(data[at] % 3),
                             fog::load_le32(data + at + 4),
                             data[at + 1] % 33U,
                             {}};
    at += 8;
    for (std::size_t i = 0; i < message.size && at + 4 <= size; ++i, at += 4) {
      message.words[i] = fog::load_le32(data + at);
    }
    const std::size_t bytes = fog::encode_load_message(message, sealed.data());
    for (std::size_t i = 0; i < bytes; ++i) feed(sealed[i]);
  }
  if (flash.writes == 0) return;
  const auto& used = flash.slot(0);
  promise(std::count(used.begin(), used.end(), -1) == static_cast<std::ptrdiff_t>(used.size()),
          "the slot in use is not touched");
  flash = {};
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  load(data, size);
  return 0;
}
