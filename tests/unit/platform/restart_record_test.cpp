#include "platform/shared/restart_record.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>

namespace {

using fog::hal::CrashRecord;
using fog::hal::ResetCause;
using fog::platform::RestartRecord;

constexpr CrashRecord kCrash{3, 0x08001234, 0x08004321, 0x00020000, 0, 4711};

bool same(const CrashRecord& a, const CrashRecord& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// The record is in uninitialised memory: here, bytes filled by a test.
struct Memory {
  alignas(RestartRecord) std::array<unsigned char, sizeof(RestartRecord)> bytes{};
  RestartRecord& record() { return *reinterpret_cast<RestartRecord*>(bytes.data()); }
};

TEST(RestartRecord, TellsTheNextStartAndThenForgetsTheCauseButNotTheCrash) {
  Memory memory;
  memory.record().keep(ResetCause::fault, kCrash);
  auto report = memory.record().take(ResetCause::software);
  EXPECT_EQ(report.cause, ResetCause::fault);
  EXPECT_TRUE(same(report.last_crash, kCrash));
  report = memory.record().take(ResetCause::reset_pin);
  EXPECT_EQ(report.cause, ResetCause::reset_pin);
  EXPECT_TRUE(same(report.last_crash, kCrash));
}

TEST(RestartRecord, CountsWhatTheBoardRestartedForUntilSomebodyElseDoes) {
  Memory memory;
  memory.record().take(ResetCause::power_on);
  const auto after = [&](ResetCause ours, ResetCause hardware) {
    if (ours != ResetCause::unknown) memory.record().keep(ours, kCrash);
    return memory.record().take(hardware).counts;
  };
  EXPECT_EQ(after(ResetCause::clock_failure, ResetCause::software).clock_failures, 1U);
  EXPECT_EQ(after(ResetCause::clock_failure, ResetCause::software).clock_failures, 2U);
  EXPECT_EQ(after(ResetCause::fault, ResetCause::software).faults, 1U);
  EXPECT_EQ(after(ResetCause::unknown, ResetCause::watchdog).faults, 2U);
  EXPECT_EQ(after(ResetCause::self_test, ResetCause::software).faults, 3U);
  EXPECT_EQ(after(ResetCause::unknown, ResetCause::software).faults, 3U) << "a debugger's";
  memory.record().forget_faults();
  const auto forgiven = after(ResetCause::fault, ResetCause::software);
  EXPECT_EQ(forgiven.faults, 1U);
  EXPECT_EQ(forgiven.clock_failures, 2U);
  const auto pulled = after(ResetCause::unknown, ResetCause::reset_pin);
  EXPECT_EQ(pulled.faults + pulled.clock_failures, 0U);
}

TEST(RestartRecord, CountsFromNothingWhereAStartFailsBeforeItWasTaken) {
  Memory memory;
  memory.bytes.fill(0x77);
  memory.record().keep(ResetCause::fault, kCrash);
  EXPECT_EQ(memory.record().take(ResetCause::software).counts.faults, 1U);
}

TEST(RestartRecord, BelievesNothingOfWhatPowerOnLeavesInMemory) {
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) {
    Memory memory;
    for (unsigned char& byte : memory.bytes) {
      byte = static_cast<unsigned char>(i == 0 ? 0 : i == 1 ? 0xFF : random());
    }
    const auto report = memory.record().take(ResetCause::power_on);
    ASSERT_EQ(report.cause, ResetCause::power_on);
    ASSERT_TRUE(same(report.last_crash, {}));
    ASSERT_EQ(report.counts.faults + report.counts.clock_failures, 0U);
  }
}

TEST(RestartRecord, IsNotBelievedWithAnyBitFlipped) {
  for (std::size_t bit = 0; bit < 8 * sizeof(RestartRecord); ++bit) {
    Memory memory;
    memory.record().keep(ResetCause::fault, kCrash);
    memory.bytes[bit / 8] = static_cast<unsigned char>(memory.bytes[bit / 8] ^ (1U << (bit % 8)));
    const auto report = memory.record().take(ResetCause::software);
    ASSERT_EQ(report.cause, ResetCause::software) << bit;
    ASSERT_TRUE(same(report.last_crash, {})) << bit;
  }
}

}  // namespace
