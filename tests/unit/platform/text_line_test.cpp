#include "platform/text_line.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace {

using fog::platform::TextLine;

TEST(TextLine, WritesNumbersInFull) {
  TextLine line;
  line.text("a ").decimal(0).text(" ").decimal(4294967295U).text(" ").hex(0xDEADBEEFU).hex(0);
  EXPECT_STREQ(line.c_str(), "a 0 4294967295 0xdeadbeef0x00000000");
}

TEST(TextLine, CutsOffWhatDoesNotFit) {
  TextLine line;
  for (int i = 0; i < 50; ++i) line.decimal(1234567890);
  EXPECT_EQ(std::strlen(line.c_str()), 151U);
}

}  // namespace
