#include "core/frames/load_message.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"

namespace fog {
namespace {

// A5 9B | step | words | at | the words | CRC-32;  C3 9B | step | refusal | next | CRC-32
constexpr std::uint8_t kMessageSync = 0xA5;
constexpr std::uint8_t kAnswerSync = 0xC3;
constexpr std::uint8_t kSync1 = 0x9B;
constexpr std::size_t kStepAt = 2;
constexpr std::size_t kSizeAt = 3;
constexpr std::size_t kArgumentAt = 4;
constexpr std::size_t kAnswerCrcAt = 8;
constexpr auto kLastStep = static_cast<std::uint8_t>(LoadStep::end);
constexpr auto kLastRefusal = static_cast<std::uint8_t>(LoadRefusal::not_expected);

void store_header(std::uint8_t* bytes, std::uint8_t sync, LoadStep step, std::uint8_t number,
                  std::uint32_t argument) {
  bytes[0] = sync;
  bytes[1] = kSync1;
  bytes[kStepAt] = static_cast<std::uint8_t>(step);
  bytes[kSizeAt] = number;
  store_le32(bytes + kArgumentAt, argument);
}

}  // namespace

std::size_t encode_load_message(const LoadMessage& message, std::uint8_t* out) {
  store_header(out, kMessageSync, message.step, static_cast<std::uint8_t>(message.size),
               message.at);
  std::size_t size = kLoadHeaderBytes;
  for (std::size_t i = 0; i < message.size; ++i, size += 4)
    store_le32(out + size, message.words[i]);
  store_le32(out + size, crc32(out, size));
  return size + 4;
}

LoadAnswerBytes encode_load_answer(const LoadAnswer& answer) {
  LoadAnswerBytes bytes{};
  store_header(bytes.data(), kAnswerSync, answer.step, static_cast<std::uint8_t>(answer.refusal),
               answer.next);
  store_le32(&bytes[kAnswerCrcAt], crc32(bytes.data(), kAnswerCrcAt));
  return bytes;
}

bool decode_load_answer(const std::uint8_t* bytes, LoadAnswer& answer) {
  if (bytes[0] != kAnswerSync || bytes[1] != kSync1) return false;
  if (bytes[kStepAt] > kLastStep || bytes[kSizeAt] > kLastRefusal) return false;
  if (load_le32(bytes + kAnswerCrcAt) != crc32(bytes, kAnswerCrcAt)) return false;
  answer = {static_cast<LoadStep>(bytes[kStepAt]), static_cast<LoadRefusal>(bytes[kSizeAt]),
            load_le32(bytes + kArgumentAt)};
  return true;
}

bool LoadParser::feed(std::uint8_t byte) {
  bytes_[size_++] = byte;
  if (!is_possible()) {
    size_ = 0;
    if (byte == kMessageSync) bytes_[size_++] = byte;
    return false;
  }
  if (size_ < kLoadHeaderBytes || size_ < kLoadHeaderBytes + std::size_t{4} * bytes_[kSizeAt] + 4U)
    return false;
  const bool good = read();
  size_ = 0;
  return good;
}

bool LoadParser::is_possible() const {
  return bytes_[0] == kMessageSync && (size_ < 2 || bytes_[1] == kSync1) &&
         (size_ <= kStepAt || bytes_[kStepAt] <= kLastStep) &&
         (size_ <= kSizeAt || bytes_[kSizeAt] <= kMaxLoadWords);
}

bool LoadParser::read() {
  const std::size_t end = size_ - 4;
  if (load_le32(&bytes_[end]) != crc32(bytes_.data(), end)) return false;
  message_.step = static_cast<LoadStep>(bytes_[kStepAt]);
  message_.size = bytes_[kSizeAt];
  message_.at = load_le32(&bytes_[kArgumentAt]);
  for (std::size_t i = 0; i < message_.size; ++i) {
    message_.words[i] = load_le32(&bytes_[kLoadHeaderBytes + 4 * i]);
  }
  return true;
}

}  // namespace fog
