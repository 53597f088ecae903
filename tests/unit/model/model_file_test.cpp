#include "model/model_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "export/header.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"

namespace {

using fogcomp::InputError;

std::string error_of(const std::string& text) {
  try {
    fogcomp::parse_model(text, "gyro.model");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ModelFile, ReadsBackToTheSameBits) {
  const std::string text = fogcomp::model_text(fog::test::paper_like_model());
  EXPECT_EQ(fogcomp::model_text(fogcomp::parse_model(text, "gyro.model")), text);
}

TEST(ModelFile, RefusesEveryDamagedByte) {
  const std::string good = fogcomp::model_text(fog::test::paper_like_model());
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    ASSERT_NE(error_of(damaged), "accepted") << i;
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    ASSERT_NE(error_of(good.substr(0, size)), "accepted") << size;
  }
}

TEST(ModelFile, NamesFileLineAndRemedy) {
  EXPECT_EQ(error_of("time_s,rate_dph\n"),
            "gyro.model: is not a fogcomp model; fogcomp fit makes one");
  EXPECT_EQ(error_of("fogcomp-model 9\ncrc 0\n"),
            "gyro.model:1: is a model of another version ('fogcomp-model 9', this fogcomp reads "
            "'fogcomp-model 1'); fit it again");
}

TEST(Header, ReadsBackToTheSameTable) {
  const fogcomp::BoardTable table = fogcomp::make_board_table(fog::test::paper_like_model(), {});
  const std::string text = fogcomp::header_text(table, "gyro.model", 0x1234);
  EXPECT_EQ(fogcomp::parse_header(text, "fog_model.h").words, table.words);
}

TEST(Header, RefusesAChangedNumber) {
  const fogcomp::BoardTable table = fogcomp::make_board_table(fog::test::paper_like_model(), {});
  std::string text = fogcomp::header_text(table, "gyro.model", 0x1234);
  const std::size_t digit = text.find("2101248000");
  ASSERT_NE(digit, std::string::npos);
  text[digit] = '1';
  try {
    fogcomp::parse_header(text, "fog_model.h");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "fog_model.h: model table damaged (CRC); export the header again");
  }
}

}  // namespace
