#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "hal/rate_sink.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::test::Stm32F405Model;
using Bytes = std::vector<std::uint8_t>;

constexpr int kOutput = 1;

void start() {
  fog::platform::start_clock_tree();
  fog::platform::open_output_port(fog::SerialLine());
}

void send(const Bytes& bytes) {
  fog::hal::write_output_stream(bytes.data(), bytes.size());
}

constexpr std::uint64_t kLong = 10000;  // for what is under way to finish

Bytes frame(std::uint8_t seed, std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(seed + 3 * i);
  return bytes;
}

void expect_no_violations(const Stm32F405Model& board) {
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

TEST(DmaOutput, ReturnsAtOnceAndSendsLater) {
  Stm32F405Model board;
  start();
  const std::uint64_t before = board.accesses();
  send(frame(1, 64));
  EXPECT_LT(board.accesses() - before, 20U);
  EXPECT_TRUE(board.sent(kOutput).empty());
  board.let_pass(kLong);
  EXPECT_EQ(board.sent(kOutput), frame(1, 64));
  expect_no_violations(board);
}

TEST(DmaOutput, KeepsFramesInOrderHoweverFastTheyCome) {
  Stm32F405Model board;
  start();
  std::mt19937 random(1);
  Bytes expected;
  for (int i = 0; i < 500; ++i) {
    const Bytes next = frame(static_cast<std::uint8_t>(random()), 1 + random() % 200);
    expected.insert(expected.end(), next.begin(), next.end());
    send(next);
    if (random() % 4 == 0) board.let_pass(kLong);
  }
  board.let_pass(kLong);
  EXPECT_EQ(board.sent(kOutput), expected);
  expect_no_violations(board);
}

TEST(DmaOutput, GivesUpATransferThatNeverEndsAndSendsTheNext) {
  Stm32F405Model board;
  start();
  board.faults.dma_never_ends = true;
  const std::uint64_t before = board.accesses();
  send(frame(1, 64));
  send(frame(2, 64));
  EXPECT_LT(board.accesses() - before, 110'000U);
  board.faults.dma_never_ends = false;
  board.let_pass(kLong);
  EXPECT_EQ(board.sent(kOutput), frame(2, 64));
  expect_no_violations(board);
}

TEST(DmaOutput, ReturnsEvenWhereTheStreamCannotBeStopped) {
  Stm32F405Model board;
  start();
  board.faults.dma_never_ends = true;
  board.faults.dma_cannot_be_stopped = true;
  const std::uint64_t before = board.accesses();
  for (int i = 0; i < 3; ++i) send(frame(1, 64));
  EXPECT_LT(board.accesses() - before, 3U * 110'000U);
}

}  // namespace
