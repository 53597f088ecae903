#include "board/board_texts.hpp"

#include <gtest/gtest.h>

#include "board/board_table.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"

namespace fogcomp::board {
namespace {

TEST(Identity, ASerialNumberComesBackFromItsWords) {
  for (const std::string serial : {"", "1", "FOG-0042", "ABCDEFGHIJKLMNO", "~!#"}) {
    EXPECT_EQ(serial_text(serial_words(serial).data()), serial);
  }
  EXPECT_EQ(serial_words("FOG-1")[0], 0x2D474F46U);
  for (const std::string serial : {"ABCDEFGHIJKLMNOP", "A B", "\xC3\xA4", "A\n"}) {
    EXPECT_THROW(serial_words(serial), InputError) << serial;
  }
}

TEST(Identity, AProcessorsNumberIsWhatHealthPrints) {
  const ProcessorNumber number{0x00340051, 0x57355012, 0x2032394D};
  EXPECT_EQ(processor_text(number), "00340051573550122032394d");
  EXPECT_EQ(parse_processor_number("00340051573550122032394D"), number);
  for (const std::string text : {"", "00340051573550122032394", "00340051573550122032394dd",
                                 "0x340051573550122032394d", "000000000000000000000000"}) {
    EXPECT_THROW(parse_processor_number(text), InputError) << text;
  }
}

TEST(Identity, IsInTheTableWhereTheBoardLooksForIt) {
  model::Model model = fog::test::paper_like_model();
  model.serial = "FOG-0042";
  BoardSettings settings;
  settings.processor = {1, 2, 0xFFFFFFFF};
  const auto serial_in = [](const BoardTable& table) {
    std::array<std::uint32_t, 4> words{};
    for (std::size_t i = 0; i < 4; ++i) {
      words[i] = static_cast<std::uint32_t>(table.words[fog::kIdentityAt + i]);
    }
    return serial_text(words.data());
  };
  const BoardTable table = make_board_table(model, settings);
  EXPECT_EQ(serial_in(table), "FOG-0042");
  EXPECT_FALSE(fog::is_bound_elsewhere(&table.words[fog::kProcessorAt], settings.processor));
  EXPECT_TRUE(fog::is_bound_elsewhere(&table.words[fog::kProcessorAt], {1, 2, 3}));
  settings.serial = "FOG-0043";
  EXPECT_EQ(serial_in(make_board_table(model, settings)), "FOG-0043");
}

TEST(Identity, OfTheGyroIsKeptInTheModelFile) {
  model::Model model = fog::test::paper_like_model();
  EXPECT_EQ(model::parse_model(model::model_text(model), "test").serial, "");
  model.serial = "FOG-0042";
  EXPECT_EQ(model::parse_model(model::model_text(model), "test").serial, "FOG-0042");
}

}  // namespace
}  // namespace fogcomp::board
