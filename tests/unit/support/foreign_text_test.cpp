#include <gtest/gtest.h>

#include "support/input_error.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace {

using fogcomp::displayable;
using fogcomp::valid_utf8;

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(ForeignText, BecomesUtf8ByteForByte) {
  const std::string good =
      "Rampe 60\xC2\xB0"
      "C \xE2\x88\x9A \xF0\x9F\x94\xA5";
  EXPECT_EQ(valid_utf8(good), good);
  EXPECT_EQ(valid_utf8("Rampe 60\xB0"
                       "C"),
            "Rampe 60" + kReplaced + "C");
  // Overlong, a surrogate, beyond Unicode, cut off.
  for (const std::string bad :
       {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x88", "\x80"}) {
    std::string replaced;
    for (std::size_t i = 0; i < bad.size(); ++i) replaced += kReplaced;
    EXPECT_EQ(valid_utf8(bad), replaced);
  }
}

TEST(ForeignText, IsNotObeyedByATerminal) {
  EXPECT_EQ(displayable("a\x1B[31mb\tc\nd\x7F"), "a?[31mb?c?d?");
  EXPECT_EQ(displayable("a\xC2\x9B"
                        "31m"),
            "a?31m");  // CSI in one character
  EXPECT_EQ(displayable("a\x9B"
                        "31m\x80"),
            "a?31m?");  // and in one byte, to a terminal of 8 bits
  EXPECT_EQ(displayable("60 \xC2\xB0"
                        "C"),
            "60 \xC2\xB0"
            "C");
}

TEST(ForeignText, IsValidJson) {
  EXPECT_EQ(fogcomp::Json("\xB0\x1B\x7F\"").text(), "\"" + kReplaced + "\\u001b\\u007f\\\"\"");
  EXPECT_EQ(fogcomp::Json("60 \xC2\xB0\xC2\x9B").text(), "\"60 \xC2\xB0\\u009b\"");
  EXPECT_EQ(fogcomp::Json("\xE2\x88\x9A").text(), "\"\xE2\x88\x9A\"");
}

TEST(ForeignText, IsNoNameOfAFile) {
  EXPECT_NO_THROW(fogcomp::require_printable_name("Z\xFCrich/60 \xC2\xB0.csv"));
  EXPECT_NO_THROW(fogcomp::require_printable_name("\xE2\x88\x9A.csv"));  // 9A in a character
  for (const std::string name : {"a\nb.csv", "a\x9B.csv", "a\xC2\x9B.csv"}) {
    EXPECT_THROW(fogcomp::require_printable_name(name), fogcomp::InputError);
  }
}

TEST(Rounded, HasTheDigitsThatDeserveIt) {
  EXPECT_EQ(fogcomp::rounded(1919.2848), "1919");
  EXPECT_EQ(fogcomp::rounded(-13565.5863), "-13566");
  EXPECT_EQ(fogcomp::rounded(15.04107), "15.04");
  EXPECT_EQ(fogcomp::rounded(1.89321), "1.893");
  EXPECT_EQ(fogcomp::rounded(0.054321), "0.05432");
  EXPECT_EQ(fogcomp::rounded(0.0012346), "0.001235");
  EXPECT_EQ(fogcomp::signed_rounded(0.186), "+0.1860");
  EXPECT_EQ(fogcomp::signed_rounded(-2.5), "-2.500");
  EXPECT_EQ(fogcomp::rounded(2e-16), "0");
  EXPECT_EQ(fogcomp::rounded(-0.0), "0");
}

TEST(TimeText, IsInTheUnitInWhichItIsRead) {
  EXPECT_EQ(fogcomp::time_text(40), "40 s");
  EXPECT_EQ(fogcomp::time_text(432), "7.2 min");
  EXPECT_EQ(fogcomp::time_text(9360), "2.6 h");
}

TEST(Counted, HasASingularAndAPlural) {
  EXPECT_EQ(fogcomp::counted(0, "bad row"), "0 bad rows");
  EXPECT_EQ(fogcomp::counted(1, "bad row"), "1 bad row");
  EXPECT_EQ(fogcomp::counted(6, "bad row"), "6 bad rows");
}

TEST(ProposedCommand, OfStandardInput_NamesAFileInstead) {
  EXPECT_EQ(fogcomp::shell_words({"fogcomp", "fit", "-", "a b.csv"}), "fogcomp fit FILE 'a b.csv'");
}

}  // namespace
