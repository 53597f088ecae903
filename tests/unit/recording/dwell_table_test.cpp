// Tables of means at steady temperatures.
#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <string>

#include "heard_in.hpp"
#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

const char* const kTable = "T [degC],rate_dph,input_rate_dph\n65,3,0\n-40,1,100\n20,2,0\n20,2,0\n";

ReadOptions of_table() {
  ReadOptions options;
  options.is_table = true;
  return options;
}

std::string refusal_of(const std::string& content, const ReadOptions& options) {
  try {
    read_recording(temporary_file("table.csv", content), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DwellTable, Lines_AreSettledRows) {
  std::string said;
  ReadOptions options = heard_in(said);
  options.is_table = true;
  const Recording table = read_recording(temporary_file("table.csv", kTable), options);
  EXPECT_TRUE(table.is_table);
  EXPECT_EQ(table.temperature_degc, (std::vector<double>{65, -40, 20, 20}));
  EXPECT_EQ(table.rate_dph, (std::vector<double>{3, 1, 2, 2}));
  EXPECT_EQ(table.input_rate_dph, (std::vector<double>{0, 100, 0, 0}));
  EXPECT_EQ(table.stretch_starts.size(), table.rows());
  EXPECT_EQ(table.period_s, 0);
  EXPECT_LT(table.time_s.back(), 0);  // no time since power-on
  EXPECT_NE(said.find("a table: each line is the mean of a steady temperature"), std::string::npos)
      << said;
}

TEST(DwellTable, FileWithTimes_TheirOrderIsNotRead) {
  const Recording table = read_recording(
      temporary_file("table.csv", "time_s,temperature_degc,rate_dph\n50,20,1\n7,30,2\n"),
      of_table());
  EXPECT_EQ(table.rows(), 2U);
}

TEST(DwellTable, FileWithoutTimes_RefusedWithBothWays) {
  const std::string refusal = refusal_of(kTable, {});
  EXPECT_NE(refusal.find("without times: --rate HZ (even samples) or --table (means at steady "
                         "temperatures)"),
            std::string::npos)
      << refusal;
}

TEST(DwellTable, TimeInTheMap_Refused) {
  ReadOptions options = of_table();
  options.columns = "time=1[s]";
  EXPECT_NE(refusal_of(kTable, options).find("leave time= out of --columns"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::recording
