#include "support/text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace fogcomp {
namespace {

// RFC 4648, chapter 10, and bytes that are negative as characters.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xFF\xFE\x00\x80", 4)), "//4AgA==");
}

}  // namespace
}  // namespace fogcomp
