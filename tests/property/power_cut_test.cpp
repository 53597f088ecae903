// A power failure while a table is loaded, and another while it is loaded again: at every byte,
// with the flashed code. The board always has a good table, the old or the new one, and can be
// loaded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "board/table_files.hpp"
#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "support/cut_flash.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::LoadAnswer;
using fog::LoadMessage;
using fog::LoadRefusal;
using fog::LoadStep;
using fog::SlotChoice;
using fog::test::CutFlash;
using fogcomp::board::BoardSettings;
using Loader = fog::SlotLoader<CutFlash>;
using Words = std::vector<std::uint32_t>;

constexpr fogcomp::board::ProcessorNumber kProcessor{1, 2, 3};

BoardSettings of_gyro(const std::string& serial) {
  BoardSettings settings = fog::test::lenient_board();
  settings.serial = serial;
  return settings;
}

Words slot_of(std::uint32_t sequence, const BoardSettings& settings = of_gyro("G1")) {
  const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
  const std::string bytes = fogcomp::board::slot_bytes(table, sequence, "test");
  Words words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

SlotChoice boot(const CutFlash& flash) {
  fog::ModelParameters parameters;
  return fog::choose_slot(flash.both(), fog::kGenericImage, kProcessor, parameters);
}

LoadMessage begin_of(const Words& slot, std::uint32_t options = 0) {
  LoadMessage message{LoadStep::begin, options, fog::kLoadHeadWords, {}};
  std::copy_n(slot.begin(), fog::kLoadHeadWords, message.words.begin());
  return message;
}
LoadMessage block_of(const Words& slot, std::size_t at) {
  const std::size_t size = std::min(fog::kMaxLoadWords, slot.size() - at);
  LoadMessage message{
      LoadStep::block, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(size), {}};
  std::copy_n(slot.begin() + static_cast<std::ptrdiff_t>(at), size, message.words.begin());
  return message;
}
const LoadMessage kEnd{LoadStep::end, 0, 0, {}};

LoadRefusal load(Loader& loader, const Words& slot, std::uint32_t options = 0) {
  LoadAnswer answer = loader.take(begin_of(slot, options), true);
  while (answer.refusal == LoadRefusal::none && answer.next < slot.size()) {
    answer = loader.take(block_of(slot, answer.next), true);
  }
  if (answer.refusal == LoadRefusal::none) answer = loader.take(kEnd, true);
  return answer.refusal;
}
fog::LoadTarget target_of(const CutFlash& flash) {
  return fog::load_target(boot(flash), flash.both(), kProcessor);
}
LoadRefusal load(CutFlash& flash, const Words& slot, std::uint32_t options = 0) {
  Loader loader(flash, target_of(flash), fog::kGenericImage);
  return load(loader, slot, options);
}

// What a board has before a load, and whose table is loaded.
struct CutLoad {
  const char* name;
  std::vector<const char*> before;  // serial numbers of the tables loaded so far, one after another
  std::uint32_t damaged;            // the table, from 1, that is damaged then; 0: none
  const char* serial;               // of the table that is loaded
};
const CutLoad kCutLoads[] = {
    {"VirginBoard", {}, 0, "G1"},
    {"OneTable", {"G1"}, 0, "G1"},
    {"TwoTables", {"G1", "G1"}, 0, "G1"},
    {"NewerTableDamaged", {"G1", "G1"}, 2, "G1"},
    {"OnlyTableDamaged", {"G1"}, 1, "G1"},
    {"OtherGyro", {"G1"}, 0, "G2"},
    {"OtherGyroThirdTable", {"G1", "G1"}, 0, "G2"},
};

// Plays a load up to each state in which a power failure can leave the flash, and there the load
// that follows, which is cut likewise.
class CutLoads : public testing::TestWithParam<CutLoad> {
 protected:
  static std::uint32_t used_in(const CutFlash& flash) {  // sequence; 0: no table
    const SlotChoice choice = boot(flash);
    return choice.error == fog::ModelError::none ? choice.used().sequence : 0;
  }
  CutFlash before() const {
    CutFlash flash;
    for (const char* serial : GetParam().before) {
      const std::uint32_t sequence = used_in(flash) + 1;
      EXPECT_EQ(load(flash, slot_of(sequence, of_gyro(serial)), fog::kMayBeFirst),
                LoadRefusal::none);
    }
    if (GetParam().damaged != 0) flash.slot(boot(flash).slot)[60] ^= 1;
    return flash;
  }
  // With `cuts` of 0 the load is not cut.
  void load_cut(CutFlash flash, int cuts) {
    const std::uint32_t used = used_in(flash);
    const std::size_t erased = flash.erases;
    bool is_erased = false;
    flash.may_be_cut = [&] {
      if (cuts > 0) {
        ++states_;
        const std::uint32_t left = used_in(flash);
        ASSERT_TRUE(left == used || left == used + 1) << left << " instead of " << used;
        load_cut(flash, cuts - 1);
      }
      if (is_erased || flash.erases == erased) return;
      is_erased = true;
      if (cuts < kCuts && was_seen(flash, used)) throw IsSeen();
      if (cuts > 0) seen_.push_back({used, flash.slot(0), flash.slot(1)});
    };
    try {
      ASSERT_EQ(load(flash, table(used + 1), fog::kMayBeFirst | fog::kMayBeAnotherGyro),
                LoadRefusal::none);
      flash.may_be_cut = {};
      ASSERT_EQ(used_in(flash), used + 1);
    } catch (const IsSeen&) {
    }
  }
  const Words& table(std::uint32_t sequence) {
    Words& words = tables_[sequence];
    if (words.empty()) words = slot_of(sequence, of_gyro(GetParam().serial));
    return words;
  }
  static constexpr int kCuts = 2;
  std::size_t states_ = 0;

 private:
  struct IsSeen {};  // what follows has been played from the same state
  struct Erased {
    std::uint32_t used;
    CutFlash::Memory first;
    CutFlash::Memory second;
  };
  bool was_seen(CutFlash& flash, std::uint32_t used) const {
    return std::any_of(seen_.begin(), seen_.end(), [&](const Erased& erased) {
      return erased.used == used && erased.first == flash.slot(0) && erased.second == flash.slot(1);
    });
  }
  std::map<std::uint32_t, Words> tables_;
  std::vector<Erased> seen_;
};

TEST_P(CutLoads, CutTwice_OldTableOrNewOneAndLoadable) {
  load_cut(before(), kCuts);
  EXPECT_GT(states_, 4 * table(1).size());
  std::printf("%zu states\n", states_);
}
INSTANTIATE_TEST_SUITE_P(PowerCut, CutLoads, testing::ValuesIn(kCutLoads),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Repeatedly, at any byte, until one load succeeds.
TEST(PowerCut, LeavesABoardThatCanBeLoaded) {
  struct PowerIsGone {};
  std::mt19937 random(7);
  CutFlash flash;
  ASSERT_EQ(load(flash, slot_of(1), fog::kMayBeFirst), LoadRefusal::none);
  std::uint32_t used = 1;
  for (int i = 0; i < 200; ++i) {
    const Words slot = slot_of(used + 1);
    const std::size_t last = flash.writes + 1 + random() % (4 * slot.size() + 200);
    flash.may_be_cut = [&] {
      if (flash.writes >= last) throw PowerIsGone();
    };
    try {
      ASSERT_EQ(load(flash, slot), LoadRefusal::none);
      ++used;
    } catch (const PowerIsGone&) {
    }
    flash.may_be_cut = {};
    const SlotChoice choice = boot(flash);
    ASSERT_EQ(choice.error, fog::ModelError::none) << i;
    const std::uint32_t left = choice.used().sequence;  // the new one, from within its last word on
    ASSERT_TRUE(left == used || left == used + 1) << i;
    used = left;
  }
  EXPECT_GT(used, 10U);
}

class Loading : public testing::Test {
 protected:
  Loading() { EXPECT_EQ(load(flash_, slot_of(1), fog::kMayBeFirst), LoadRefusal::none); }
  // Refused with a reason; the table in use is unchanged; nothing is erased unless `erases`.
  void expect_refused(LoadRefusal refusal, const Words& slot, bool erases = false) {
    const std::size_t before = flash_.erases;
    EXPECT_EQ(load(flash_, slot), refusal);
    EXPECT_EQ(flash_.erases, before + (erases ? 1 : 0));
    EXPECT_EQ(boot(flash_).error, fog::ModelError::none);
    EXPECT_EQ(boot(flash_).used().sequence, 1U);
  }
  /// Other words in the table of a slot, and its CRC and seal.
  static Words with(std::map<std::size_t, std::uint32_t> words, Words slot) {
    for (const auto& [at, word] : words) slot[at] = word;
    const std::size_t crc = slot.size() - 2;
    const auto* const table = reinterpret_cast<const std::int32_t*>(slot.data());
    slot[crc] =
        fog::model_table_crc({table + fog::kSlotHeaderWords, crc + 1 - fog::kSlotHeaderWords});
    return sealed(slot);
  }
  static Words sealed(Words slot) {
    auto* const bytes = reinterpret_cast<std::uint8_t*>(slot.data());
    const std::size_t size = 4 * slot.size() - 4;
    const auto seal = fog::seal_of(fog::crc32(bytes, size, fog::kIntactImage));
    std::copy(seal.begin(), seal.end(), bytes + size);
    return slot;
  }
  Loader loader() { return {flash_, target_of(flash_), fog::kGenericImage}; }

  CutFlash flash_;
};

TEST_F(Loading, NeedsTheStrapAtEveryStep) {
  const Words slot = slot_of(2);
  Loader open = loader();
  EXPECT_EQ(open.take(begin_of(slot), false).refusal, LoadRefusal::strap_open);
  EXPECT_FALSE(open.has_begun());
  Loader opened_later = loader();
  EXPECT_EQ(opened_later.take(begin_of(slot), true).refusal, LoadRefusal::none);
  EXPECT_EQ(opened_later.take(block_of(slot, fog::kLoadHeadWords), false).refusal,
            LoadRefusal::strap_open);
  EXPECT_EQ(opened_later.take(kEnd, false).refusal, LoadRefusal::strap_open);
  EXPECT_EQ(boot(flash_).used().sequence, 1U);
}

TEST_F(Loading, RefusesWhatIsNotForThisBoardBeforeAnythingIsErased) {
  BoardSettings elsewhere = of_gyro("G1");
  elsewhere.processor = {3, 2, 1};
  expect_refused(LoadRefusal::other_board, slot_of(2, elsewhere));
  expect_refused(LoadRefusal::other_gyro, slot_of(2, of_gyro("G2")));
  expect_refused(LoadRefusal::not_newer, slot_of(1));
  expect_refused(LoadRefusal::not_newer, slot_of(0));
  Words slot = slot_of(2);
  slot[0] ^= 1U;
  expect_refused(LoadRefusal::not_a_model, slot);
  slot = slot_of(2);
  slot[4] ^= 1U;
  expect_refused(LoadRefusal::not_a_model, slot);
  for (const std::size_t layout : {1U, 5U}) {
    slot = slot_of(2);
    ++slot[layout];
    expect_refused(LoadRefusal::other_layout, slot);
  }
  slot = slot_of(2);
  slot[3] = slot[6] = fog::kMaxSlotWords + 1;
  expect_refused(LoadRefusal::not_in_image, slot);
  slot = slot_of(2);
  ++slot[3];
  expect_refused(LoadRefusal::damaged, slot);
  slot = slot_of(2);
  slot[3] = slot[6] = fog::kProcessorAt + fog::kProcessorWords;  // ends before its first section
  expect_refused(LoadRefusal::damaged, slot);
}

TEST_F(Loading, TakesTheTableOfAnotherGyroWhereItIsToldSo) {
  EXPECT_EQ(load(flash_, slot_of(2, of_gyro("G2")), fog::kMayBeAnotherGyro), LoadRefusal::none);
  EXPECT_EQ(boot(flash_).used().sequence, 2U);
}

TEST_F(Loading, TableWithoutSerial_Loaded_OpensNoWay) {
  expect_refused(LoadRefusal::other_gyro, slot_of(2, of_gyro("")));
  EXPECT_EQ(load(flash_, slot_of(2, of_gyro("")), fog::kMayBeAnotherGyro), LoadRefusal::none);
  EXPECT_EQ(load(flash_, slot_of(3, of_gyro("G2"))), LoadRefusal::other_gyro);
  EXPECT_EQ(load(flash_, slot_of(3, of_gyro("G1"))), LoadRefusal::other_gyro);
  EXPECT_EQ(load(flash_, slot_of(3, of_gyro(""))), LoadRefusal::none);
}

TEST(VirginBoard, FirstTable_NotMeant_Refused) {
  CutFlash flash;
  EXPECT_EQ(load(flash, slot_of(1)), LoadRefusal::no_owner);
  EXPECT_EQ(flash.erases, 0U);
  EXPECT_EQ(load(flash, slot_of(1), fog::kMayBeFirst), LoadRefusal::none);
}

// The owner is the damaged table's.
TEST_F(Loading, OnlyTable_Damaged_BoardStaysItsGyros) {
  flash_.slot(boot(flash_).slot)[60] ^= 1;
  ASSERT_EQ(boot(flash_).error, fog::ModelError::damaged);
  EXPECT_EQ(load(flash_, slot_of(2, of_gyro("G2")), fog::kMayBeFirst), LoadRefusal::other_gyro);
  EXPECT_EQ(load(flash_, slot_of(2)), LoadRefusal::none);
}

// Whatever is damaged, the first word of the new table included.
TEST_F(Loading, OtherGyro_Loaded_OldTableRetired) {
  const std::size_t old = boot(flash_).slot;
  ASSERT_EQ(load(flash_, slot_of(2, of_gyro("G2")), fog::kMayBeAnotherGyro), LoadRefusal::none);
  EXPECT_EQ(boot(flash_).slots[old].error, fog::ModelError::not_a_model);
  for (const std::size_t word : {0U, 2U, 60U}) {
    CutFlash flash = flash_;
    flash.slot(old ^ 1U)[word] ^= 1;
    EXPECT_NE(boot(flash).slot, old) << word;
  }
}

// One that stayed would be in doubt with the new one.
TEST_F(Loading, OtherSlotDamaged_OtherGyroLoaded_Retired) {
  ASSERT_EQ(load(flash_, slot_of(2)), LoadRefusal::none);
  const std::size_t last = boot(flash_).slot;
  ASSERT_EQ(last, 1U);
  flash_.slot(last)[60] ^= 1;
  flash_.slot(0)[60] ^= 1;
  ASSERT_EQ(boot(flash_).slot, fog::kModelSlots);
  ASSERT_EQ(load(flash_, slot_of(3, of_gyro("G2")), fog::kMayBeAnotherGyro), LoadRefusal::none);
  EXPECT_EQ(boot(flash_).slot, 0U);
  EXPECT_EQ(boot(flash_).slots[1].error, fog::ModelError::not_a_model);
}

// Half an erase of a slot whose first word was 0: also on a board that was never loaded.
TEST(VirginBoard, SlotsThatAreNone_NoOwner) {
  CutFlash flash;
  for (const std::size_t slot : {0U, 1U}) flash.slot(slot).assign(flash.slot(slot).size(), 0x5A);
  EXPECT_EQ(load(flash, slot_of(1)), LoadRefusal::no_owner);
  EXPECT_EQ(load(flash, slot_of(1), fog::kMayBeFirst), LoadRefusal::none);
  EXPECT_EQ(boot(flash).error, fog::ModelError::none);
}

TEST_F(Loading, RefusesWhatTurnsOutToBeNoGoodTableBeforeItIsOne) {
  Words damaged = slot_of(2);
  damaged[60] ^= 4U;
  expect_refused(LoadRefusal::damaged, damaged, true);
  Words table_damaged = slot_of(2);
  table_damaged[60] ^= 4U;
  expect_refused(LoadRefusal::damaged, sealed(table_damaged), true);
  BoardSettings settings = of_gyro("G1");
  auto model = fog::test::paper_like_model();
  model.denoise.levels = fog::kGenericLevels + 1;
  const auto table = fogcomp::board::make_board_table(model, settings);
  Words large = slot_of(2);
  large.resize(fog::kSlotHeaderWords);
  large[3] = static_cast<std::uint32_t>(table.words.size());
  for (const std::int32_t word : table.words) large.push_back(static_cast<std::uint32_t>(word));
  large.push_back(0);
  expect_refused(LoadRefusal::not_in_image, sealed(large), true);
}

TEST_F(Loading, PeriodTooShortForFramesOrCost_Refused) {
  constexpr std::size_t kPeriodAt =
      fog::kSlotHeaderWords + fog::kProcessorAt + fog::kProcessorWords;
  const Words slot = slot_of(2);
  const std::size_t output_line_at = slot.size() - 3;
  constexpr std::uint32_t kShortUs = 100;
  expect_refused(LoadRefusal::frames_too_long, with({{kPeriodAt, kShortUs}}, slot), true);
  expect_refused(LoadRefusal::sample_too_dear,
                 with({{kPeriodAt, kShortUs}, {output_line_at, 4'147'200}}, slot), true);
}

TEST_F(Loading, RefusesATableThatEndsEarlyAndBlocksThatDoNotFollow) {
  const Words slot = slot_of(2);
  Loader board = loader();
  EXPECT_EQ(board.take(kEnd, true).refusal, LoadRefusal::not_expected);
  EXPECT_EQ(board.take(block_of(slot, fog::kLoadHeadWords), true).refusal,
            LoadRefusal::not_expected);
  ASSERT_EQ(board.take(begin_of(slot), true).refusal, LoadRefusal::none);
  EXPECT_EQ(board.take(block_of(slot, fog::kLoadHeadWords + 1), true).refusal,
            LoadRefusal::not_expected);
  EXPECT_EQ(board.take(block_of(slot, fog::kLoadHeadWords), true).refusal, LoadRefusal::none);
  EXPECT_EQ(board.take(kEnd, true).refusal, LoadRefusal::not_expected);
  LoadMessage beyond = block_of(slot, fog::kLoadHeadWords + 32);
  while (board.take(beyond, true).refusal == LoadRefusal::none) beyond.at += 32;
  EXPECT_LE(beyond.at, slot.size()) << "nothing behind the slot is written";
  EXPECT_EQ(boot(flash_).used().sequence, 1U);
}

TEST_F(Loading, Block_NotWhatIsDue_Refused) {
  const Words slot = slot_of(2);
  Loader board = loader();
  LoadMessage head = begin_of(slot);
  --head.size;
  EXPECT_EQ(board.take(head, true).refusal, LoadRefusal::not_expected);
  ++head.size;
  ASSERT_EQ(board.take(head, true).refusal, LoadRefusal::none);
  const LoadMessage block = block_of(slot, fog::kLoadHeadWords);
  ASSERT_EQ(board.take(block, true).refusal, LoadRefusal::none);
  LoadMessage other = block;
  other.words[0] ^= 1U;  // not what was written there
  EXPECT_EQ(board.take(other, true).refusal, LoadRefusal::not_expected);
  other = block;
  --other.size;
  EXPECT_EQ(board.take(other, true).refusal, LoadRefusal::not_expected);
  other.size = static_cast<std::uint32_t>(slot.size()) + 1;
  EXPECT_EQ(board.take(other, true).refusal, LoadRefusal::not_expected);
  EXPECT_EQ(load(board, slot), LoadRefusal::none);
  EXPECT_EQ(board.take(block, true).refusal, LoadRefusal::not_expected);
}

TEST_F(Loading, TakesAStepOnceWhoseAnswerWasLost) {
  const Words slot = slot_of(2);
  Loader board = loader();
  LoadAnswer answer = board.take(begin_of(slot), true);
  answer = board.take(begin_of(slot), true);
  while (answer.next < slot.size()) {
    const LoadMessage block = block_of(slot, answer.next);
    const std::size_t before = flash_.writes;
    answer = board.take(block, true);
    ASSERT_EQ(flash_.writes, before + 4 * block.size);
    ASSERT_EQ(board.take(block, true).refusal, LoadRefusal::none);
    ASSERT_EQ(flash_.writes, before + 4 * block.size);
  }
  EXPECT_EQ(board.take(kEnd, true).refusal, LoadRefusal::none);
  EXPECT_EQ(board.take(kEnd, true).refusal, LoadRefusal::none);
  EXPECT_TRUE(board.has_ended());
  EXPECT_EQ(board.take(begin_of(slot), true).refusal, LoadRefusal::not_expected);
  EXPECT_EQ(boot(flash_).used().sequence, 2U);
}

TEST_F(Loading, FindsAFlashThatDoesNotHoldWhatIsWritten) {
  flash_.fails = true;
  EXPECT_EQ(load(flash_, slot_of(2)), LoadRefusal::flash_failed);
  flash_.fails = false;
  flash_.is_deaf = true;
  EXPECT_EQ(load(flash_, slot_of(2)), LoadRefusal::flash_failed);
  EXPECT_EQ(boot(flash_).used().sequence, 1U);
}

// From each of its calls on, with and without a report; the last one makes the table good.
TEST_F(Loading, FlashFailing_AtAnyCall_OldTableStays) {
  for (bool CutFlash::*const failure : {&CutFlash::fails, &CutFlash::is_deaf}) {
    std::size_t calls = 0;
    LoadRefusal refusal = LoadRefusal::flash_failed;
    for (std::size_t good = 0; refusal != LoadRefusal::none; ++good) {
      CutFlash flash = flash_;
      calls = 0;
      flash.before_call = [&] { flash.*failure = ++calls > good; };
      refusal = load(flash, slot_of(2));
      const bool is_loaded = refusal == LoadRefusal::none;
      ASSERT_TRUE(is_loaded || refusal == LoadRefusal::flash_failed) << good;
      ASSERT_EQ(boot(flash).used().sequence, is_loaded ? 2U : 1U) << good;
    }
    EXPECT_GT(calls, 5U);
  }
}

}  // namespace
