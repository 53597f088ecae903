// The messages for loading a table, on a line that damages them.
#include "core/frames/load_message.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using fog::LoadAnswer;
using fog::LoadMessage;
using fog::LoadParser;
using fog::LoadRefusal;
using fog::LoadStep;
using Bytes = std::vector<std::uint8_t>;

LoadMessage block(std::uint32_t at, std::uint32_t size) {
  LoadMessage message{LoadStep::block, at, size, {}};
  for (std::uint32_t i = 0; i < size; ++i) message.words[i] = at * 77U + i * 0x01010101U;
  return message;
}
Bytes bytes_of(const LoadMessage& message) {
  Bytes bytes(fog::kMaxLoadBytes);
  bytes.resize(fog::encode_load_message(message, bytes.data()));
  return bytes;
}
// The messages found in `bytes`.
std::vector<LoadMessage> parse(LoadParser& parser, const Bytes& bytes) {
  std::vector<LoadMessage> found;
  for (const std::uint8_t byte : bytes) {
    if (parser.feed(byte)) found.push_back(parser.message());
  }
  return found;
}
void expect_same(const LoadMessage& a, const LoadMessage& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.at, b.at);
  ASSERT_EQ(a.size, b.size);
  for (std::size_t i = 0; i < a.size; ++i) EXPECT_EQ(a.words[i], b.words[i]);
}

TEST(LoadMessage, IsReadAsItWasSentWhateverItsSize) {
  LoadParser parser;
  for (std::uint32_t size = 0; size <= fog::kMaxLoadWords; ++size) {
    const auto found = parse(parser, bytes_of(block(size, size)));
    ASSERT_EQ(found.size(), 1U);
    expect_same(found[0], block(size, size));
  }
}

TEST(LoadMessage, IsNotBelievedWithAnyBitFlipped) {
  const Bytes good = bytes_of(block(15, 8));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
    LoadParser parser;
    ASSERT_TRUE(parse(parser, bad).empty()) << bit;
  }
}

TEST(LoadMessage, ComesThroughAfterWhateverStandsBeforeItIfItIsSentAgain) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    LoadParser parser;
    Bytes line(random() % 300);
    for (auto& byte : line) byte = random() % 3 == 0 ? 0xA5 : static_cast<std::uint8_t>(random());
    if (line.size() > 8) line[4] = 0xA5, line[5] = 0x9B, line[6] = 1, line[7] = 32;
    parse(parser, line);
    std::size_t sent = 1;
    while (parse(parser, bytes_of(block(7, 32))).empty()) ++sent;
    ASSERT_LE(sent, 3U);
  }
}

TEST(LoadAnswer, IsReadAsItWasSentAndNotWithAnyBitFlipped) {
  for (std::uint8_t refusal = 0; refusal <= 11; ++refusal) {
    const auto good =
        fog::encode_load_answer({LoadStep::block, static_cast<LoadRefusal>(refusal), 4096});
    LoadAnswer read;
    ASSERT_TRUE(fog::decode_load_answer(good.data(), read));
    EXPECT_EQ(fog::encode_load_answer(read), good);
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
      auto bad = good;
      bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
      EXPECT_FALSE(fog::decode_load_answer(bad.data(), read)) << bit;
    }
  }
}

}  // namespace
