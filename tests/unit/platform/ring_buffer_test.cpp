#include "platform/ring_buffer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>

namespace {

using fog::platform::RingBuffer;

TEST(RingBuffer, ReturnsBytesInTheOrderTheyCame) {
  RingBuffer<8> ring;
  for (std::uint8_t byte = 1; byte <= 5; ++byte) EXPECT_TRUE(ring.push(byte));
  std::array<std::uint8_t, 8> out{};
  EXPECT_EQ(ring.pop(out.data(), 3), 3U);
  EXPECT_EQ(ring.pop(out.data() + 3, 5), 2U);
  EXPECT_EQ(out, (std::array<std::uint8_t, 8>{1, 2, 3, 4, 5, 0, 0, 0}));
  EXPECT_EQ(ring.pop(out.data(), out.size()), 0U);
}

TEST(RingBuffer, UsesItsWholeCapacityAndThenRefuses) {
  RingBuffer<4> ring;
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(ring.is_full());
    EXPECT_TRUE(ring.push(7));
  }
  EXPECT_TRUE(ring.is_full());
  EXPECT_FALSE(ring.push(8));
  std::array<std::uint8_t, 5> out{};
  EXPECT_EQ(ring.pop(out.data(), out.size()), 4U);
  EXPECT_EQ(out, (std::array<std::uint8_t, 5>{7, 7, 7, 7, 0}));
}

TEST(RingBuffer, LosesAndReordersNothingBetweenTwoThreads) {
  constexpr std::uint32_t kBytes = 2'000'000;
  RingBuffer<64> ring;
  std::thread producer([&ring] {
    for (std::uint32_t i = 0; i < kBytes;) {
      if (ring.push(static_cast<std::uint8_t>(i * 37U))) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  std::uint32_t received = 0;
  std::uint32_t wrong = 0;
  std::array<std::uint8_t, 13> out{};
  while (received < kBytes) {
    const std::size_t count = ring.pop(out.data(), out.size());
    if (count == 0) std::this_thread::yield();
    for (std::size_t i = 0; i < count; ++i, ++received) {
      if (out[i] != static_cast<std::uint8_t>(received * 37U)) ++wrong;
    }
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
