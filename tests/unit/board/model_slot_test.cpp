// Tables as files for a programmer, and tables that exceed the generic image's capacity.
#include "board/table_files.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/input_error.hpp"
#include "support/sample_models.hpp"

namespace {

using fogcomp::InputError;
using fogcomp::board::BoardTable;

fogcomp::model::Model with_denoiser(const std::string& wavelet, int levels) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.denoise.wavelet = wavelet;
  model.denoise.levels = levels;
  return model;
}

std::string refusal(const fogcomp::model::Model& model) {
  try {
    fogcomp::board::slot_bytes(fogcomp::board::make_board_table(model, {}), 1, "gyro.model");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ModelSlotFile, GivesBackTheTableThatWentIn) {
  const BoardTable table = fogcomp::board::make_board_table(fog::test::paper_like_model(), {});
  const std::string bytes = fogcomp::board::slot_bytes(table, 5, "test");
  EXPECT_TRUE(fogcomp::board::looks_like_slot(bytes));
  EXPECT_EQ(fogcomp::board::parse_slot(bytes, "test").words, table.words);
  std::string damaged = bytes;
  damaged[100] = static_cast<char>(damaged[100] ^ 1);
  EXPECT_THROW(fogcomp::board::parse_slot(damaged, "test"), InputError);
  EXPECT_THROW(fogcomp::board::parse_slot(bytes.substr(0, 99), "test"), InputError);
}

TEST(ModelSlotFile, BytesBehindTheTable_RefusedByName) {
  const BoardTable table = fogcomp::board::make_board_table(fog::test::paper_like_model(), {});
  const std::string bytes = fogcomp::board::slot_bytes(table, 5, "test");
  for (const std::size_t more : {1U, 2U, 3U, 4U, 100U, 20'000U}) {
    for (const char with : {'\0', '\xFF', 'x'}) {
      try {
        fogcomp::board::parse_slot(bytes + std::string(more, with), "gyro.bin");
        FAIL() << more;
      } catch (const InputError& error) {
        EXPECT_EQ(error.what(), "gyro.bin: has " + std::to_string(more) +
                                    " bytes after the table; export it again");
      }
    }
  }
}

TEST(ModelSlotFile, WhatTheGenericImageHasNoRoomForIsRefusedByName) {
  EXPECT_EQ(refusal(with_denoiser("sym8", 6)), "");
  EXPECT_EQ(refusal(with_denoiser("sym8", 0)), "");
  EXPECT_NE(refusal(with_denoiser("sym8", 7)).find("up to 6 levels, not 7"), std::string::npos);
  EXPECT_NE(refusal(with_denoiser("db4", 3)).find("filters of 16 taps"), std::string::npos);
}

// Checked against `objcopy -I binary -O ihex --change-addresses 0x08010000`.
TEST(ModelSlotFile, IntelHexIsAtTheSlotsAddress) {
  EXPECT_EQ(fogcomp::board::slot_hex(std::string("0123456789abcdef\x01", 17), 1),
            ":020000040801F1\n"
            ":10000000303132333435363738396162636465668E\n"
            ":0100100001EE\n"
            ":00000001FF\n");
  EXPECT_EQ(fogcomp::board::slot_hex("0", 0), ":020000040800F2\n:01C00000300F\n:00000001FF\n");
}

}  // namespace
