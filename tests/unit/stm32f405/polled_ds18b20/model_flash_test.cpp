// Erasing and writing the model slots as the manual requires, within the watchdog's time, by code
// that runs from the same flash.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hal/model_memory.hpp"
#include "hal/service_strap.hpp"
#include "hal/watchdog.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "support/processor_stand_in.hpp"
#include "support/stm32f405_model.hpp"

namespace {

using fog::hal::erase_model_memory;
using fog::hal::program_model_memory;
using fog::test::Stm32F405Model;
using fog::test::Stm32Flash;

constexpr std::array<std::uint32_t, 2> kSlots{0x0800C000, 0x08010000};
constexpr std::array<std::uint32_t, 3> kWords{0x53474F46, 0x00000000, 0x89ABCDEF};

class ModelFlash : public testing::Test {
 protected:
  ModelFlash() {
    fog::platform::start_clock_tree();
    fog::hal::start_watchdog(fog::hal::kWatchdogLoopMs);
  }
  void expect_no_violations() {
    for (const std::string& violation : board_.violations()) ADD_FAILURE() << violation;
  }
  std::uint32_t word(std::size_t slot, std::uint32_t at) const {
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      value |= std::uint32_t{board_.flash.byte(kSlots[slot] + 4 * at + i)} << (8 * i);
    }
    return value;
  }
  void expect_as_before() {
    EXPECT_TRUE(board_.flash.locked());
    EXPECT_FALSE(fog::test::writes_allowed());
    EXPECT_EQ(board_.stored(0x40023C00), 7U | 6U << 8U) << "caches on, and not held empty";
  }

  Stm32F405Model board_;
};

TEST_F(ModelFlash, IsErasedAndWrittenAtAnySupplyAndLockedAgain) {
  for (const double supply_v : {3.3, 1.8}) {
    board_.supply_v = supply_v;
    for (std::size_t slot = 0; slot < kSlots.size(); ++slot) {
      board_.flash.set_byte(kSlots[slot] + 5, 0);
      EXPECT_TRUE(erase_model_memory(slot));
      fog::hal::kick_watchdog();
      expect_as_before();
      EXPECT_EQ(word(slot, 1), 0xFFFFFFFFU);
      EXPECT_TRUE(program_model_memory(slot, 7, kWords.data(), kWords.size()));
      fog::hal::kick_watchdog();
      expect_as_before();
      for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(word(slot, 7 + i), kWords[i]);
      EXPECT_EQ(word(slot, 6), 0xFFFFFFFFU);
      EXPECT_EQ(word(slot, 10), 0xFFFFFFFFU);
    }
  }
  EXPECT_EQ(board_.flash.erases(), 4U);
  EXPECT_NEAR(board_.watchdog_timeout_s(32'000), 6, 1e-9) << "until the caller starts it again";
  expect_no_violations();
}

// A whole message, by the slowest flash.
TEST_F(ModelFlash, LeavesTheWatchdogItsTime) {
  const std::array<std::uint32_t, 32> words{};
  erase_model_memory(1);
  for (std::size_t at = 0; at < 4096; at += words.size()) {
    fog::hal::kick_watchdog();
    EXPECT_TRUE(program_model_memory(1, at, words.data(), words.size()));
  }
  EXPECT_GT(board_.elapsed_s(), 2.4 + 1.6);
  expect_no_violations();
}

TEST_F(ModelFlash, SaysWhatItsFlashRefuses) {
  board_.flash.write_protected = true;
  EXPECT_FALSE(erase_model_memory(0));
  EXPECT_FALSE(program_model_memory(0, 0, kWords.data(), kWords.size()));
  EXPECT_EQ(word(0, 0), 0xFFFFFFFFU);
  board_.flash.write_protected = false;
  EXPECT_TRUE(erase_model_memory(0)) << "the errors of last time are cleared";
  expect_as_before();
  expect_no_violations();
}

TEST_F(ModelFlash, EndsWhereItsFlashDoesNot) {
  board_.flash.never_ready = true;
  EXPECT_FALSE(erase_model_memory(0));
  EXPECT_LT(board_.accesses(), 300'000U);
}

TEST_F(ModelFlash, GoesOnWhereADebuggerHasLeftItUnlocked) {
  board_.write(0x40023C04, 0x45670123);
  board_.write(0x40023C04, 0xCDEF89AB);
  EXPECT_TRUE(erase_model_memory(0));
  expect_as_before();
  expect_no_violations();
}

TEST(ModelFlashModel, SaysNoToEveryForbiddenOrder) {
  const auto expect = [](const std::string& what, auto act) {
    Stm32F405Model board;
    fog::test::writes_allowed() = true;
    act(board);
    EXPECT_EQ(board.violations(), std::set<std::string>{what});
    fog::test::writes_allowed() = false;
  };
  const auto unlock = [](Stm32F405Model& board) {
    board.write(0x40023C04, 0x45670123);
    board.write(0x40023C04, 0xCDEF89AB);
  };
  const std::uint32_t control = 0x40023C10;
  const std::uint32_t erase_3 = 1U << 1U | 3U << 3U;
  const std::uint32_t start = 1U << 16U;
  expect("flash control written while it is locked",
         [&](auto& board) { board.write(control, erase_3); });
  expect("wrong key for the flash", [&](auto& board) { board.write(0x40023C04, 0xCDEF89AB); });
  expect("wrong key for the flash", [&](auto& board) {
    unlock(board);
    board.write(0x40023C04, 0x45670123);
  });
  expect("a sector erased that is in use", [&](auto& board) {
    unlock(board);
    board.write(control, 1U << 1U | 2U << 3U | start);
  });
  expect("flash started with nothing to do, or with two things", [&](auto& board) {
    unlock(board);
    board.write(control, start);
  });
  expect("flash started with nothing to do, or with two things", [&](auto& board) {
    unlock(board);
    board.write(control, erase_3 | start | 1U);
  });
  expect("flash control written while it is busy", [&](auto& board) {
    unlock(board);
    board.write(0x40023C00, 6U << 8U);  // runs from its caches
    board.write(control, erase_3 | start);
    board.write(control, 1);
  });
  expect("flash written without PG", [&](auto& board) {
    unlock(board);
    board.write_byte(0x0800C000, 1);
  });
  expect("flash written without PG", [&](auto& board) { board.write_byte(0x0800C000, 1); });
  expect("a byte written with another width", [&](auto& board) {
    unlock(board);
    board.write(control, 1U | 2U << 8U);
    board.write_byte(0x0800C000, 1);
  });
  expect("flash written wider than the supply allows", [&](auto& board) {
    board.supply_v = 2.6;
    unlock(board);
    board.write(control, 1U | 2U << 8U);
  });
  expect("flash written that is not erased", [&](auto& board) {
    unlock(board);
    board.write(control, 1);
    board.write_byte(0x0800C000, 1);
    board.write_byte(0x0800C000, 2);
  });
  expect("a sector written that is in use", [&](auto& board) {
    unlock(board);
    board.write(control, 1);
    board.write_byte(0x0800BFFF, 1);
  });
  expect("memory protection: the flash is read-only", [&](auto& board) {
    fog::test::writes_allowed() = false;
    board.write_byte(0x0800C000, 1);
  });
  expect("a cache emptied that is on",
         [&](auto& board) { board.write(0x40023C00, 1U << 12U | 1U << 10U); });
}

// The strap that enables loading: an open input must not be taken for closed, however slowly it
// rises.
TEST(ServiceStrap, IsOpenUnlessItIsClosedAllTheTime) {
  Stm32F405Model board;
  EXPECT_FALSE(fog::hal::service_strap_closed());
  board.strap_closed = [] { return true; };
  EXPECT_TRUE(fog::hal::service_strap_closed());
  int reads = 0;
  board.strap_closed = [&] { return ++reads % 500 != 0; };  // a loose contact
  EXPECT_FALSE(fog::hal::service_strap_closed());
  for (const std::string& violation : board.violations()) ADD_FAILURE() << violation;
}

}  // namespace
