#include "core/bytes/crc.hpp"

namespace fog {
namespace {

// Four bits at a time: the table has 16 words instead of 256, and the longest frame takes less than
// a thousand instructions.
template <typename Word>
struct NibbleTable {
  Word entry[16];
};

template <typename Word>
constexpr NibbleTable<Word> make_table(Word polynomial) {
  constexpr unsigned top_bit = sizeof(Word) * 8U - 1U;
  NibbleTable<Word> table{};
  for (unsigned nibble = 0; nibble < 16U; ++nibble) {
    Word remainder = static_cast<Word>(static_cast<std::uint32_t>(nibble) << (top_bit - 3U));
    for (int bit = 0; bit < 4; ++bit) {
      const bool carry = ((remainder >> top_bit) & 1U) != 0;
      remainder = static_cast<Word>(remainder << 1U);
      if (carry) remainder = static_cast<Word>(remainder ^ polynomial);
    }
    table.entry[nibble] = remainder;
  }
  return table;
}

template <typename Word>
Word crc_msb_first(const NibbleTable<Word>& table, const std::uint8_t* bytes, std::size_t size,
                   Word crc) {
  constexpr unsigned top_nibble = sizeof(Word) * 8U - 4U;
  const auto shift_in = [&table, &crc](unsigned nibble) {
    const unsigned index = (static_cast<unsigned>(crc >> top_nibble) ^ nibble) & 0xFU;
    crc = static_cast<Word>(static_cast<Word>(crc << 4U) ^ table.entry[index]);
  };
  for (std::size_t i = 0; i < size; ++i) {
    shift_in(static_cast<unsigned>(bytes[i]) >> 4U);
    shift_in(bytes[i]);
  }
  return crc;
}

constexpr auto kTable16 = make_table<std::uint16_t>(0x1021);
constexpr auto kTable32 = make_table<std::uint32_t>(0x04C11DB7U);

}  // namespace

std::uint16_t crc16(const std::uint8_t* bytes, std::size_t size, std::uint16_t crc) {
  return crc_msb_first(kTable16, bytes, size, crc);
}

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size, std::uint32_t crc) {
  return crc_msb_first(kTable32, bytes, size, crc);
}

// Bit by bit, least significant bit first: only eight bytes per second come here.
std::uint8_t crc8(const std::uint8_t* bytes, std::size_t size) {
  constexpr unsigned kReflectedPolynomial = 0x8C;
  unsigned crc = 0;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1U) != 0 ? (crc >> 1U) ^ kReflectedPolynomial : crc >> 1U;
    }
  }
  return static_cast<std::uint8_t>(crc);
}

}  // namespace fog
