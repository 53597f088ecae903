#include "board/model_slot.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/model_slot.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

void append_word(std::string& bytes, std::uint32_t word) {
  std::array<std::uint8_t, 4> four{};
  fog::store_le32(four.data(), word);
  bytes.append(four.begin(), four.end());
}

// Details of the error "not in image" of `read_model`.
void require_room(const BoardTable& table, const std::string& file) {
  const fog::ModelParameters parameters = read_board_table(table, file);
  const fog::DenoiseParameters& denoise = parameters.denoise;
  if (denoise.levels() > fog::kGenericImage.levels) {
    throw InputError(file, format("the generic image has denoisers of up to %zu levels, not %zu; "
                                  "fit it with fewer, or build an image of its own",
                                  fog::kGenericImage.levels, denoise.levels()));
  }
  if ((fog::kGenericImage.filters & fog::filters_of(denoise.taps())) == 0) {
    throw InputError(file, format("the generic image has filters of %zu taps, as sym8 and db8 are, "
                                  "not of %zu; fit it with --wavelet sym8, or build an image of "
                                  "its own",
                                  fog::kGenericTaps % fog::kOrNone, denoise.taps()));
  }
  if (table.words.size() > fog::kMaxSlotWords) {
    throw InputError(file, format("a table of %zu words, of which a slot holds %zu",
                                  table.words.size(), fog::kMaxSlotWords));
  }
  fog::ModelParameters generic;
  const fog::ModelError error = fog::read_model(table.span(), fog::kGenericImage, generic);
  if (error != fog::ModelError::none) throw InputError(file, fog::describe(error));
}

std::string hex_record(std::uint8_t type, std::uint16_t address, const std::string& data) {
  std::string bytes{static_cast<char>(data.size()), static_cast<char>(address >> 8U),
                    static_cast<char>(address), static_cast<char>(type)};
  bytes += data;
  std::uint8_t sum = 0;
  for (const char byte : bytes)
    sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(byte));
  bytes += static_cast<char>(0x100U - sum);
  std::string line = ":";
  for (const char byte : bytes) line += format("%02X", static_cast<std::uint8_t>(byte));
  return line + "\n";
}

}  // namespace

std::string slot_bytes(const BoardTable& table, std::uint32_t sequence, const std::string& file) {
  require_room(table, file);
  std::string bytes;
  append_word(bytes, static_cast<std::uint32_t>(fog::kSlotMagic));
  append_word(bytes, static_cast<std::uint32_t>(fog::kSlotLayout));
  append_word(bytes, sequence);
  append_word(bytes, static_cast<std::uint32_t>(table.words.size()));
  for (const std::int32_t word : table.words) append_word(bytes, static_cast<std::uint32_t>(word));
  const auto seal = fog::seal_of(fog::crc32(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            bytes.size(), fog::kIntactImage));
  return bytes.append(seal.begin(), seal.end());
}

bool looks_like_slot(const std::string& bytes) {
  std::string magic;
  append_word(magic, static_cast<std::uint32_t>(fog::kSlotMagic));
  return bytes.compare(0, magic.size(), magic) == 0;
}

BoardTable parse_slot(const std::string& bytes, const std::string& file) {
  std::vector<std::int32_t> words(bytes.size() / sizeof(std::int32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::int32_t));
  const fog::SlotContents slot = fog::read_slot({words.data(), words.size()});
  if (slot.error != fog::ModelError::none) {
    throw InputError(
        file, std::string("a table that is ") + fog::describe(slot.error) + "; export it again");
  }
  if (slot.sealed.size != bytes.size()) {
    throw InputError(file, format("has %zu bytes after the table; export it again",
                                  bytes.size() - slot.sealed.size));
  }
  BoardTable table;
  table.words.assign(slot.table.begin(), slot.table.end());
  read_board_table(table, file);
  return table;
}

std::string slot_hex(const std::string& bytes, unsigned slot) {
  constexpr std::array<std::uint32_t, fog::kModelSlots> kAddresses{0x0800C000, 0x08010000};
  const std::uint32_t address = kAddresses.at(slot);
  const std::string upper{static_cast<char>(address >> 24U), static_cast<char>(address >> 16U)};
  std::string text = hex_record(4, 0, upper);
  constexpr std::size_t kLine = 16;
  for (std::size_t at = 0; at < bytes.size(); at += kLine) {
    text += hex_record(0, static_cast<std::uint16_t>(address + at), bytes.substr(at, kLine));
  }
  return text + hex_record(1, 0, "");
}

}  // namespace fogcomp::board
