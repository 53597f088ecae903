// What somebody who is to say which column is which is shown of a CSV.

#include <gtest/gtest.h>

#include "recording/csv_layout.hpp"

namespace fogcomp::recording {
namespace {

CsvColumns look(const std::string& text, const std::string& columns = "") {
  ReadOptions options;
  options.columns = columns;
  return look_at_columns({text, true, false, "a.csv"}, options);
}

TEST(ColumnLook, NamesWhatIsUnderstood) {
  const CsvColumns found = look("time_s,temperature_degc,rate_dph\n0,20,1\n10,21,2\n");
  EXPECT_EQ(found.refusal, "");
  ASSERT_EQ(found.columns.size(), 3U);
  EXPECT_EQ(found.columns[0].key, "time");
  EXPECT_EQ(found.columns[1].key, "temperature");
  EXPECT_EQ(found.columns[2].key, "rate");
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_EQ(found.rows[1][1], "21");
}

TEST(ColumnLook, ShowsWhatCouldBeTheRateOfAFileThatIsRefused) {
  const CsvColumns found = look("Time [s];T [degC];Gyro_X [deg/s];Gyro_Y [deg/s]\n0;20;1;2\n");
  EXPECT_NE(found.refusal.find("rate could be"), std::string::npos) << found.refusal;
  EXPECT_EQ(found.separator, "';'");
  ASSERT_EQ(found.columns.size(), 4U);
  EXPECT_EQ(found.columns[2].key, "rate");
  EXPECT_EQ(found.columns[3].key, "rate");
  EXPECT_EQ(found.columns[3].unit, "deg/s");
  ASSERT_EQ(found.rows.size(), 1U);
  EXPECT_EQ(found.rows[0][3], "2");
}

TEST(ColumnLook, TakesTheChoiceThatItProposes) {
  const std::string text = "Stamp;Chamber;Gyro_X;Gyro_Y\n0;20;1;2\n10;20;1;2\n";
  const CsvColumns found = look(text);
  EXPECT_NE(found.refusal, "");
  ASSERT_EQ(found.columns.size(), 4U);
  const std::string map = "time=" + found.columns[0].choice +
                          "[s],temperature=" + found.columns[1].choice +
                          "[degC],rate=" + found.columns[3].choice + "[deg/h]";
  const CsvColumns chosen = look(text, map);
  EXPECT_EQ(chosen.refusal, "");
  EXPECT_EQ(chosen.columns[2].key, "");
  EXPECT_EQ(chosen.columns[3].key, "rate");
}

// --columns parts names at commas, and two columns of one name are told apart by their numbers.
TEST(ColumnLook, NamesAColumnByItsNumberWhereItsNameWouldNotDo) {
  const CsvColumns found = look("a;\"b, c\";d;d\n0;20;1;2\n");
  ASSERT_EQ(found.columns.size(), 4U);
  EXPECT_EQ(found.columns[0].choice, "a");
  EXPECT_EQ(found.columns[1].choice, "2");
  EXPECT_EQ(found.columns[2].choice, "3");
}

TEST(ColumnLook, OfUnknownNamesTheHeaderIsShownAndNoRowWithDecimalCommas) {
  const CsvColumns found = look("Stamp;Chamber;Gyro_X\n0,5;20,1;1,25\n1,5;20,2;1,5\n");
  EXPECT_EQ(found.separator, "';'");
  ASSERT_EQ(found.columns.size(), 3U);
  EXPECT_EQ(found.columns[0].name, "Stamp");
}

TEST(ColumnLook, CountsTheColumnsOfAFileThatBeginsWithItsRows) {
  const CsvColumns found = look("0,20,1\n10,21,2\n");
  EXPECT_NE(found.refusal, "");
  ASSERT_EQ(found.columns.size(), 3U);
  EXPECT_EQ(found.columns[0].name, "");
  EXPECT_EQ(found.columns[2].choice, "3");
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_EQ(found.rows[0][1], "20");
  EXPECT_EQ(look("0,20,1\n10,21,2\n", "time=1[s],temperature=2[degC],rate=3[deg/h]").refusal, "");
}

}  // namespace
}  // namespace fogcomp::recording
