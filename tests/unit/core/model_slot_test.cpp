// The choice between the two slots of a board with the generic image.
#include "core/pipeline/model_slot.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "board/table_files.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/slots_record.hpp"
#include "core/health/image_seal.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::ModelError;
using fog::SlotChoice;
using fogcomp::board::BoardSettings;

constexpr fogcomp::board::ProcessorNumber kProcessor{1, 2, 3};

class ModelSlots : public testing::Test {
 protected:
  using Memory = std::vector<std::int32_t>;

  static std::string bytes_of(std::uint32_t sequence, const BoardSettings& settings = {}) {
    const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
    return fogcomp::board::slot_bytes(table, sequence, "test");
  }
  static Memory holding(const std::string& bytes) {
    Memory memory(fog::kSlotBytes / sizeof(std::int32_t), -1);  // erased flash
    std::memcpy(memory.data(), bytes.data(), bytes.size());
    return memory;
  }
  static Memory table(std::uint32_t sequence, const BoardSettings& settings = {}) {
    return holding(bytes_of(sequence, settings));
  }
  static Memory erased() { return holding(""); }
  static std::string flipped(std::string bytes, std::size_t bit) {
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    return bytes;
  }

  SlotChoice choose(const Memory& a, const Memory& b) {
    parameters_ = fog::ModelParameters();
    return fog::choose_slot({{{a.data(), a.size()}, {b.data(), b.size()}}}, fog::kGenericImage,
                            kProcessor, parameters_);
  }
  bool has_model() const { return parameters_.fault == fog::Status::none; }

  fog::ModelParameters parameters_;
};

TEST_F(ModelSlots, TheNewerOneIsUsedAlsoWhereTheirNumbersGoRound) {
  EXPECT_EQ(choose(table(7), table(8)).slot, 1U);
  EXPECT_EQ(choose(table(8), table(7)).slot, 0U);
  EXPECT_EQ(choose(table(8), erased()).slot, 0U);
  EXPECT_EQ(choose(erased(), table(0)).slot, 1U);
  EXPECT_EQ(choose(table(0), table(UINT32_MAX)).slot, 0U);
  EXPECT_TRUE(has_model());
}

TEST_F(ModelSlots, WithoutATableThereIsNoModel) {
  const SlotChoice choice = choose(erased(), erased());
  EXPECT_EQ(choice.error, ModelError::not_a_model);
  EXPECT_EQ(choice.slot, fog::kModelSlots);
  EXPECT_FALSE(has_model());
}

// With another serial number it may be of another gyro. The first word only says that there is a
// table, which the seal behind it shows as well.
TEST_F(ModelSlots, AnyFlippedBit_SameGyro_AGoodTableIsUsed) {
  const std::string good = bytes_of(2);
  const Memory older = table(1);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    const SlotChoice choice = choose(holding(flipped(good, bit)), older);
    constexpr std::size_t kSerialBit = 32 * (fog::kSlotHeaderWords + fog::kIdentityAt);
    if (bit >= kSerialBit && bit < kSerialBit + 32 * fog::kSerialWords) {
      ASSERT_EQ(choice.error, ModelError::damaged) << bit;
      ASSERT_EQ(choice.slots[1].error, ModelError::other_gyro) << bit;
      ASSERT_FALSE(has_model());
      continue;
    }
    ASSERT_EQ(choice.error, ModelError::none) << bit;
    ASSERT_EQ(choice.slot, bit < 32 ? 0U : 1U) << bit;
  }
}

// Whatever bit of the newer one is flipped, its sequence and what says that it is one included.
TEST_F(ModelSlots, OlderSlot_OfAnotherGyro_NeverUsed) {
  BoardSettings newer;
  newer.serial = "FOG-0043";
  const std::string good = bytes_of(2, newer);
  constexpr std::size_t kFrom43To42 = 32 * (fog::kSlotHeaderWords + fog::kIdentityAt) + 8 * 7;
  for (const char* const serial : {"FOG-0042", ""}) {
    BoardSettings older;
    older.serial = serial;
    for (std::size_t bit = 0; bit < 8 * good.size(); bit += bit < 600 ? 1 : 61) {
      if (bit == kFrom43To42) continue;  // nobody can tell: firmware/DESIGN.md, "Not promised"
      const SlotChoice choice = choose(table(1, older), holding(flipped(good, bit)));
      ASSERT_NE(choice.slot, 0U) << bit;
      ASSERT_EQ(has_model(), bit < 32) << bit;
      if (has_model()) continue;
      ASSERT_EQ(choice.error, bit < 64 ? ModelError::other_layout : ModelError::damaged) << bit;
      ASSERT_EQ(choice.newest, 1U) << bit;
      ASSERT_EQ(choice.slots[0].error, ModelError::other_gyro) << bit;
    }
    EXPECT_EQ(choose(table(1, older), holding(good)).slot, 1U);
    newer.processor = {3, 2, 1};
    EXPECT_EQ(choose(table(1, older), table(2, newer)).error, ModelError::other_board);
    newer.processor = {};
  }
}

// A load that was cut off leaves an erased first word, one of 0, or any behind which nothing fits.
TEST_F(ModelSlots, SlotThatIsNone_OfAnotherGyro_SaysNothing) {
  BoardSettings other;
  other.serial = "FOG-0043";
  for (const std::int32_t first : {-1, 0, 0x5A5A5A5A}) {
    const bool is_empty = first == -1 || first == 0;
    Memory cut = table(2, other);
    cut[0] = first;
    cut[60] ^= is_empty ? 0 : 1;
    const SlotChoice choice = choose(table(1), cut);
    EXPECT_EQ(choice.slot, 0U);
    EXPECT_EQ(choice.slots[1].error, is_empty ? ModelError::not_a_model : ModelError::damaged);
    EXPECT_FALSE(choice.slots[1].is_slot);
  }
}

// What a replay runs a board runs: but for another board's table, and one that the image has no
// room for. Each word of a table in turn, changed to what its neighbours in range are.
TEST_F(ModelSlots, TableThatAReplayRuns_Board_RunsItToo) {
  fogcomp::board::BoardTable table =
      fogcomp::board::make_board_table(fog::test::paper_like_model(), {});
  std::size_t runs = 0;
  for (std::size_t at = fog::kIdentityAt - 1; at + 1 < table.words.size(); ++at) {
    const std::int32_t word = table.words[at];
    const auto bits = static_cast<std::uint32_t>(word);
    for (const std::uint32_t change : {bits + 1, bits - 1, bits + 2, ~bits + 1, bits ^ 0x80U, 0U}) {
      table.words[at] = static_cast<std::int32_t>(change);
      table.words.back() = static_cast<std::int32_t>(fog::model_table_crc(table.span()));
      fog::ModelParameters replayed;
      const ModelError replay = fog::read_model(table.span(), fog::kAnyModel, replayed);
      Memory slot{fog::kSlotMagic, fog::kSlotLayout, 1,
                  static_cast<std::int32_t>(table.words.size())};
      slot.insert(slot.end(), table.words.begin(), table.words.end());
      const auto seal = fog::seal_of(fog::crc32(reinterpret_cast<const std::uint8_t*>(slot.data()),
                                                4 * slot.size(), fog::kIntactImage));
      std::string bytes(reinterpret_cast<const char*>(slot.data()), 4 * slot.size());
      const ModelError board =
          choose(holding(bytes.append(seal.begin(), seal.end())), erased()).error;
      const bool is_anothers =
          at >= fog::kProcessorAt && at < fog::kProcessorAt + fog::kProcessorWords && change != 0;
      const fog::DenoiseParameters& denoise = replayed.denoise;
      const bool has_room = denoise.levels() <= fog::kGenericLevels &&
                            (fog::filters_of(fog::kGenericTaps) >> (denoise.taps() / 2) & 1U) != 0;
      ModelError expected = replay;
      if (replay == ModelError::none && !has_room) expected = ModelError::not_in_image;
      if (replay == ModelError::none && is_anothers) expected = ModelError::other_board;
      ASSERT_EQ(board, expected) << "word " << at << ": " << table.words[at];
      ASSERT_EQ(has_model(), board == ModelError::none);
      runs += replay == ModelError::none ? 1 : 0;
    }
    table.words[at] = word;
  }
  EXPECT_GT(runs, 100U) << "or the test says little";
}

TEST_F(ModelSlots, OneThatIsWrittenInPartLeavesTheOlderOne) {
  const std::string good = bytes_of(2);
  for (std::size_t size = 0; size < good.size(); ++size) {
    ASSERT_EQ(choose(table(1), holding(good.substr(0, size))).slot, 0U) << size;
  }
}

TEST_F(ModelSlots, Memory_SmallerThanItsTable_Damaged) {
  const std::string bytes = bytes_of(1);
  const Memory memory = holding(bytes);
  const std::size_t words = bytes.size() / sizeof(std::int32_t);
  EXPECT_EQ(fog::read_slot({memory.data(), words}).error, ModelError::none);
  EXPECT_EQ(fog::read_slot({memory.data(), words - 1}).error, ModelError::damaged);
  EXPECT_EQ(fog::read_slot({memory.data(), fog::kSlotHeaderWords - 1}).error,
            ModelError::not_a_model);
}

TEST_F(ModelSlots, SerialNumber_NotWrittenInPart_MayBeTheSame) {
  BoardSettings other;
  other.serial = "FOG-0043";
  BoardSettings own;
  own.serial = "FOG-0042";
  const Memory a = table(1, own);
  Memory b = table(2, other);
  const auto same = [](const Memory& one, const Memory& another) {
    return fog::have_same_serial({one.data(), one.size()}, {another.data(), another.size()});
  };
  EXPECT_TRUE(same(a, a));
  EXPECT_FALSE(same(a, b));
  b[fog::kSlotHeaderWords + fog::kIdentityAt + 1] = -1;  // erased
  EXPECT_TRUE(same(a, b));
  EXPECT_TRUE(same(b, a));
}

TEST_F(ModelSlots, OneOfAnotherBoardLeavesTheOlderOneAndIsTheReasonWhereThereIsNone) {
  BoardSettings elsewhere;
  elsewhere.processor = {3, 2, 1};
  EXPECT_EQ(choose(table(1), table(2, elsewhere)).slot, 0U);
  EXPECT_EQ(choose(erased(), table(2, elsewhere)).error, ModelError::other_board);
  EXPECT_FALSE(has_model());
  BoardSettings here;
  here.processor = kProcessor;
  EXPECT_EQ(choose(table(1), table(2, here)).slot, 1U);
}

TEST_F(ModelSlots, WhatTheSelfTestGoesOverComesToAnIntactImage) {
  const Memory memory = table(1);
  const fog::SlotContents slot = fog::read_slot({memory.data(), memory.size()});
  const fog::Span<const std::uint8_t> magic = fog::slot_magic();
  const std::uint32_t crc = fog::crc32(magic.data, magic.size, fog::kIntactImage);
  EXPECT_EQ(fog::crc32(slot.sealed.data, slot.sealed.size, crc), fog::kIntactImage);
}

TEST(SlotsRecord, IsReadAsItWasSentAndNotWithAnyBitFlipped) {
  fog::SlotsRecord record;
  record.used = 1;
  record.slots[0] = {3, 7, 0xAABBCCDD, 0x11223344, {0x30473031, 0, 0, 0}};
  record.slots[1] = {0, 8, 1, 2, {0x31313131, 0x32323232, 0x33333333, 0x00343434}};
  const fog::SlotsResponse good = fog::encode_slots_response(record);
  fog::SlotsRecord read;
  ASSERT_TRUE(fog::decode_slots_response(good.data(), read));
  EXPECT_EQ(read.used, 1);
  EXPECT_EQ(fog::encode_slots_response(read), good);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    fog::SlotsResponse bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_FALSE(fog::decode_slots_response(bad.data(), read)) << bit;
  }
}

TEST(SlotsRecord, SerialNumberWithoutEnd_Refused) {
  for (const std::size_t slot : {0U, 1U}) {
    fog::SlotsRecord record;
    record.slots[slot].serial = {0x30473031, 0, 0, 0x01000000};
    fog::SlotsRecord read;
    EXPECT_FALSE(fog::decode_slots_response(fog::encode_slots_response(record).data(), read));
  }
}

TEST(SlotsRecord, IsAskedForWithARightCrc) {
  for (const fog::HealthRequest& request : {fog::kHealthRequest, fog::kSlotsRequest}) {
    EXPECT_EQ(request[4] | request[5] << 8, fog::crc16(&request[1], 3));
  }
}

TEST_F(ModelSlots, WhatIsWrongWithEachIsKnown) {
  BoardSettings elsewhere;
  elsewhere.processor = {3, 2, 1};
  const SlotChoice choice = choose(table(1), table(2, elsewhere));
  EXPECT_EQ(choice.slots[0].error, ModelError::none);
  EXPECT_EQ(choice.slots[1].error, ModelError::other_board);
  EXPECT_EQ(choose(erased(), table(2)).slots[0].error, ModelError::not_a_model);
}

}  // namespace
