#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "heard_in.hpp"
#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

const std::string kHeader = "time_s,temperature_degc,rate_dph\n";

Recording read_text(const std::string& content, const ReadOptions& options = {}) {
  return read_recording(temporary_file("recording.csv", content), options);
}

/// The message without its path: the text after "recording.csv".
std::string fault(const std::string& content, const ReadOptions& options = {}) {
  try {
    read_text(content, options);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("recording.csv") + 13);
  }
  return "no error";
}

TEST(CsvReader, TakesColumnsInAnyOrderWithCommentsCrlfAndByteOrderMark) {
  const Recording recording = read_text(
      "\xEF\xBB\xBF# chamber 3\r\n"
      "rate_dph, \"temperature_degc\" ,time_s,supply_v\r\n"
      "0.5,20,1,5.1\r\n"
      "# pause\r\n"
      " 0.25 , +21 ,\t2 ,5.2\r\n"
      "-1e-3,22.5,3,5.3\r\n\r\n");
  EXPECT_EQ(recording.time_s, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{20, 21, 22.5}));
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{0.5, 0.25, -0.001}));
  EXPECT_EQ(recording[fog::Input::supply], (std::vector<double>{5.1, 5.2, 5.3}));
  EXPECT_TRUE(recording.input_rate_dph.empty());
  EXPECT_EQ(recording.period_s, 1);
  EXPECT_EQ(recording.stretch_starts, std::vector<std::size_t>{0});
}

TEST(CsvReader, NamesUnknownColumnsOnceAndIgnoresThem) {
  std::string said;
  const Recording recording =
      read_text("time_s,note,temperature_degc,rate_dph,suply_v\n1,x y,20,0.5,\n2,nan,20,0.6,7\n",
                heard_in(said));
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{0.5, 0.6}));
  EXPECT_NE(said.find("columns ignored: note, suply_v\n"), std::string::npos) << said;
}

TEST(CsvReader, ReadsOneRowWithoutLineEnd) {
  const Recording recording = read_text(kHeader + "7.5,20,0.5");
  EXPECT_EQ(recording.rows(), 1U);
  EXPECT_EQ(recording.time_s[0], 7.5);
  EXPECT_EQ(recording.period_s, 0);
  EXPECT_EQ(recording.stretch_starts, std::vector<std::size_t>{0});
}

TEST(CsvReader, StartsAStretchAfterMoreThanOneAndAHalfPeriods) {
  const Recording recording = read_text(kHeader + "0,20,1\n1,20,1\n2.5,20,1\n3.5,20,1\n5.1,20,1\n");
  EXPECT_EQ(recording.stretch_starts, (std::vector<std::size_t>{0, 4}));
}

TEST(CsvReader, StartsAStretchWhereTheUptimeFalls) {
  const Recording recording = read_text(
      "time_s,temperature_degc,rate_dph,uptime [min]\n"
      "0,20,1,5\n10,20,1,5.2\n20,20,1,0.1\n30,20,1,0.3\n");
  EXPECT_EQ(recording.uptime_s, (std::vector<double>{300, 312, 6, 18}));
  EXPECT_EQ(recording.stretch_starts, (std::vector<std::size_t>{0, 2}));
}

TEST(CsvReader, SeesOneRestartBetweenTwoReadingsOfTheUptime) {
  const Recording recording = read_text(
      "time_s,temperature_degc,rate_dph,uptime_s\n"
      "0,20,1,500\n1,20,1,\n2,20,1,\n9,20,1,\n10,20,1,\n11,20,1,4\n");
  EXPECT_EQ(recording.uptime_s, (std::vector<double>{500, 501, 502, 2, 3, 4}));
  EXPECT_EQ(recording.stretch_starts, (std::vector<std::size_t>{0, 3}));
}

TEST(CsvReader, TurnsCountsIntoDegreesPerHour) {
  ReadOptions options;
  options.scale_factor = 7200;  // counts per deg/s: two counts per deg/h
  const Recording recording = read_text("time_s,temperature_degc,counts\n0,20,-3\n", options);
  EXPECT_EQ(recording.rate_dph[0], -1.5);
  EXPECT_NE(fault("time_s,temperature_degc,counts\n0,20,-3\n")
                .find(":1: 'counts' without a scale factor; give --scale-factor"),
            std::string::npos);
}

TEST(CsvReader, GivesAFileWithoutInputRateTheDefault) {
  ReadOptions options;
  options.default_input_rate_dph = 9.5;
  EXPECT_EQ(read_text(kHeader + "0,20,1\n", options).input_rate_dph, std::vector<double>{9.5});
  const std::string with_column = "time_s,temperature_degc,rate_dph,input_rate_dph\n0,20,1,3\n";
  EXPECT_EQ(read_text(with_column, options).input_rate_dph, std::vector<double>{3});
}

TEST(CsvReader, KeepsTheLabelsOfASegmentColumn) {
  const Recording recording = read_text(
      "time_s,temperature_degc,rate_dph,segment\n0,20,1,warm\n1,20,1,warm\n2,20,1, cold "
      "\n3,20,1,\n");
  ASSERT_EQ(recording.labels.size(), 3U);
  EXPECT_EQ(recording.labels[0].text, "warm");
  EXPECT_EQ(recording.labels[1].first_row, 2U);
  EXPECT_EQ(recording.labels[1].text, "cold");
  EXPECT_EQ(recording.labels[2].text, "");
}

TEST(CsvReader, KeepsLabelsThatCanBeShown) {
  const Recording recording =
      read_text("time_s,temperature_degc,rate_dph,segment\n0,20,1,Rampe 60\xB0\x1B[31m\n");
  ASSERT_EQ(recording.labels.size(), 1U);
  EXPECT_EQ(recording.labels[0].text, "Rampe 60\xEF\xBF\xBD?[31m");
}

TEST(CsvReader, TakesAHundredThousandColumns) {
  std::string header = "time_s,temperature_degc,rate_dph";
  std::string row = "0,20,1";
  for (int i = 0; i < 100'000; ++i) {
    header += ",c" + std::to_string(i);
    row += ",1";
  }
  EXPECT_EQ(read_text(header + "\n" + row + "\n").rows(), 1U);
}

struct BadRow {
  const char* name;
  const char* line;
  const char* message;
};

class CsvBadRow : public ::testing::TestWithParam<BadRow> {};

TEST_P(CsvBadRow, IsNamedWithItsLineAndLeftOutOnRequest) {
  const std::string remedy = "; correct the line or give --skip-bad-rows";
  const std::string content =
      kHeader + "# note\n1,20,0.5\n" + GetParam().line + "\n2,20,0.5\n3,20,0.5\n";
  EXPECT_EQ(fault(content), ":4: " + std::string(GetParam().message) + remedy);

  ReadOptions options;
  options.skip_bad_rows = true;
  const Recording recording = read_text(content, options);
  EXPECT_EQ(recording.bad_rows, 1U);
  EXPECT_EQ(recording.time_s, (std::vector<double>{1, 2, 3}));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, CsvBadRow,
    ::testing::Values(
        BadRow{"missing", "1.5,20", "2 fields where the header has 3"},
        BadRow{"extra", "1.5,20,0.5,7", "4 fields where the header has 3"},
        BadRow{"comma", "1.5,20,0.5,", "4 fields where the header has 3"},
        BadRow{"text", "1.5,20,abc", "rate_dph is 'abc', not a finite number"},
        BadRow{"unit", "1.5,20C,0.5", "temperature_degc is '20C', not a finite number"},
        BadRow{"inf", "1.5,20,-inf", "rate_dph is '-inf', not a finite number"},
        BadRow{"overflow", "1e999,20,0.5", "time_s is '1e999', not a finite number"},
        BadRow{"binary", "1.5,20,\x01", "rate_dph is '?', not a finite number"},
        BadRow{"no_value", "1.5,-999,0.5", "temperature_degc is -999, outside -273.15 to 1000"},
        BadRow{"huge", "1.5,20,1e300", "rate_dph is 1e+300, outside -1e+09 to 1e+09"},
        BadRow{"repeat", "1,20,0.75", "time_s repeats 1"},
        BadRow{"back", "0.5,20,0.5", "time_s goes back from 1 to 0.5"}),
    [](const auto& each) { return each.param.name; });

TEST(CsvReader, SaysWhereARecorderWasStartedAgain) {
  EXPECT_EQ(
      fault(kHeader + "1,20,0.5\n500,20,0.5\n2,20,0.5\n"),
      ":4: time_s begins again at 2 after 500; if the recorder was started again there, split "
      "the file at this line: each power-on is a run; correct the line or give "
      "--skip-bad-rows");
  EXPECT_EQ(fault(kHeader + "1,20,0.5\n500,20,0.5\n400,20,0.5\n"),
            ":4: time_s goes back from 500 to 400; correct the line or give --skip-bad-rows");
}

// Rows of one value each second; `line` makes others.
std::string rows_with(int count, const std::function<std::string(int row)>& line) {
  std::string text = kHeader;
  for (int row = 0; row < count; ++row) text += line(row) + "\n";
  return text;
}

TEST(BadRows, OfAnotherFormat_NoSkippingProposed) {
  const auto good = [](int row) { return format("%d,20,%d", row, row % 7); };
  ReadOptions skip;
  skip.skip_bad_rows = true;
  const std::string octal = rows_with(100, [](int row) { return format("%d,20,%oo", row, row); });
  EXPECT_NE(fault(octal).find("100 of 100 rows are bad: correct the file"), std::string::npos);
  const std::string newest = rows_with(100, [&](int row) { return good(100 - row); });
  EXPECT_NE(fault(newest).find("; the newest row stands first: sort the rows by time"),
            std::string::npos)
      << fault(newest);
  EXPECT_NE(fault(newest, skip)
                .find(":3: time_s goes back from 100 to 99; 99 of 100 rows would be "
                      "left out: correct the file"),
            std::string::npos)
      << fault(newest, skip);
  const std::string back =
      rows_with(900, [&](int row) { return good(row < 500 ? row : row - 50); });
  EXPECT_EQ(fault(back).find("--skip-bad-rows"), std::string::npos) << fault(back);
  EXPECT_NE(fault(back, skip).find(":502: time_s goes back from 499 to 450"), std::string::npos);
  const std::string header = rows_with(
      100, [&](int row) { return row == 50 ? "time_s,rate_dph,temperature_degc" : good(row); });
  EXPECT_EQ(fault(header, skip), ":52: another header; split the file at this line");
  const std::string thousands = rows_with(
      100, [](int row) { return format("%d,20,%s", row, row % 3 == 0 ? "\"1,234.5\"" : "9.5"); });
  EXPECT_NE(fault(thousands).find("not a finite number; give --decimal-mark point"),
            std::string::npos)
      << fault(thousands);
  ReadOptions point;
  point.decimal_comma = false;
  EXPECT_EQ(read_text(thousands, point).rate_dph[0], 1234.5);
}

TEST(BadRows, OfASecondRun_LeftToWhere) {
  std::string text = "run,time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 200; ++row) {
    text += format("%d,%d,20,%d\n", 1 + row / 100, row % 100, row % 7);
  }
  EXPECT_NE(fault(text).find("; --where run=1 takes the rows before it"), std::string::npos)
      << fault(text);
  ReadOptions options;
  options.where = "run=1";
  EXPECT_EQ(read_text(text, options).rows(), 100U);
}

TEST(CsvReader, RowThatStandsTwice_LeftOut) {
  std::string said;
  const std::string text = rows_with(300, [](int row) {
    const int time = row - row / 50;  // each fiftieth row is the one before
    return format("%d,20,%d", time, time % 7);
  });
  EXPECT_EQ(read_text(text, heard_in(said)).rows(), 295U);
  EXPECT_NE(said.find("5 rows left out that repeat the one before, time and values"),
            std::string::npos)
      << said;
}

TEST(CsvReader, ClockOfMinutes_SamplesAreCounted) {
  const std::string text = rows_with(
      600, [](int row) { return format("%d,20,%.3f", row / 6 * 60, std::sin(row * row)); });
  EXPECT_NE(fault(text).find("give --rate HZ"), std::string::npos) << fault(text);
  ReadOptions options;
  options.stream_rate_hz = 0.1;
  const Recording recording = read_text(text, options);
  EXPECT_EQ(recording.period_s, 10);
  EXPECT_EQ(recording.time_s[7], 70);
  options.stream_rate_hz = 0.05;
  EXPECT_NE(fault(text, options).find("do not go with 0.05 samples a second"), std::string::npos);
}

// 300 counts, as they are written.
std::string counts_text(const std::function<double(int)>& count) {
  std::string text = "time_s,temperature_degc,counts\n";
  for (int row = 0; row < 300; ++row) text += format("%d,20,%.0f\n", row, count(row));
  return text;
}

ReadOptions counting(double scale_factor, const std::string& columns = "") {
  ReadOptions options;
  options.scale_factor = scale_factor;
  options.columns = columns;
  return options;
}

// At rest, on a table that turns, and so many that one of them is no rate at all.
TEST(CsvReader, CountsWithoutSign_AskedForThenRead) {
  for (const int bits : {12, 14, 16, 18, 20, 24, 32}) {
    const double span = std::ldexp(1.0, bits);
    const bool is_usual = bits == 16 || bits >= 24;  // at half of these no gyro rests
    for (const double swing : {50.0, 0.3 * span, 0.45 * span}) {
      const auto count = [&](int row) { return std::round(swing * std::sin(row / 30.0)); };
      const auto wrapped = [&](int row) { return count(row) < 0 ? count(row) + span : count(row); };
      const auto shifted = [&](int row) { return count(row) + span / 2; };
      const double scale_factor = span / 1000;
      for (const auto& [text, unit] :
           {std::pair{counts_text(wrapped), "int"}, std::pair{counts_text(shifted), "offset"}}) {
        if (unit[0] == 'o' && !is_usual) continue;
        const std::string said = fault(text, counting(scale_factor));
        const std::string choice = format("'rate=counts[%s%d]'", unit, bits);
        EXPECT_NE(said.find(choice), std::string::npos) << said;
        EXPECT_NE(said.find(format("'rate=counts[uint%d]' (all are positive)", bits)),
                  std::string::npos)
            << said;
        const std::string columns = choice.substr(1, choice.size() - 2);
        const Recording recording = read_text(text, counting(scale_factor, columns));
        ASSERT_EQ(recording.rows(), 300U) << columns;
        EXPECT_NEAR(recording.rate_dph[200], count(200) * 3600 / scale_factor,
                    1e-6 * span / scale_factor);
      }
    }
  }
}

// Beyond the end of their register they begin at the other one.
TEST(CsvReader, CountsThatOverflow_AskedFor) {
  for (const int bits : {12, 14, 16, 18, 20, 24, 32}) {
    const double span = std::ldexp(1.0, bits);
    const std::string text = counts_text([&](int row) {
      const double count = std::round(0.6 * span * std::sin(row / 30.0));
      return count - span * std::floor(count / span + 0.5);
    });
    const std::string said = fault(text, counting(span / 1000));
    EXPECT_NE(said.find(format(": its counts jump by nearly %.0f between neighbours, as of %d bits "
                               "that overflow; add or subtract %.0f there, or say that they are "
                               "right: --columns 'rate=counts[int%d]'",
                               span, bits, span, bits)),
              std::string::npos)
        << said;
    const std::string columns = format("rate=counts[int%d]", bits);
    EXPECT_EQ(fault(text, counting(span / 1000, columns)), "no error");
  }
}

TEST(CsvReader, CountsBeyondARate_AskedForTheirSign) {
  const std::string text = counts_text([](int row) { return 4294967200.0 - row % 7; });
  for (const double scale_factor : {1e3, 1e6}) {
    const std::string said = fault(text, counting(scale_factor));
    EXPECT_NE(said.find(": its counts are 4294967194 to 4294967200, as of 32 bits without a sign; "
                        "say what they are: --columns 'rate=counts[int32]' (4294967295 is -1), "
                        "'rate=counts[offset32]' (2147483648 is 0) or 'rate=counts[uint32]' (all "
                        "are positive)"),
              std::string::npos)
        << said;
  }
  EXPECT_EQ(read_text(text, counting(1e8, "rate=counts[uint32]")).rate_dph[0],
            4294967200.0 * 3600 / 1e8);
}

// With their sign; positive ones; jumps of a table; lost samples.
TEST(CsvReader, CountsThatAreWhatTheySay_Read) {
  const std::function<double(int)> all[] = {
      [](int row) { return std::round(20000 * std::sin(row / 30.0)); },
      [](int row) { return 100.0 * row; },
      [](int row) { return row % 60 < 50 ? 1000.0 : 36000.0 + row % 7; },
      [](int row) { return row % 60 < 50 ? 7.0 + row % 7 : 4000.0 + row % 7; },
      [](int row) { return (row % 60 < 30 ? -31000.0 : 31000.0) + row % 7; },
      [](int row) { return row % 50 == 0 ? 65535.0 : 900.0 + row % 7; },
  };
  for (const auto& count : all) {
    EXPECT_EQ(fault(counts_text(count), counting(1000)), "no error");
  }
}

TEST(CsvReader, WholeRatesWithoutSign_Refused) {
  const std::string text = rows_with(300, [](int row) {
    const double rate = std::round(50 * std::sin(row));
    return format("%d,20,%.0f", row, rate < 0 ? rate + 65536 : rate);
  });
  EXPECT_NE(fault(text).find("subtract 65536 from all from 32768 on"), std::string::npos);
}

TEST(CsvReader, SaysWhatIsWrongWithTheHeader) {
  EXPECT_EQ(fault("time_s,temperature_deg,rate_dph\n1,20,1\n"),
            ":1: column 2 'temperature_deg' is in another unit, which is no unit of temperature; "
            "if it is, give the right one: --columns 'temperature=2[degC]'");
  EXPECT_EQ(fault("# a\n\ntime_s,rate_dph,rate_dph,temperature_degc\n1,20,1,1\n"),
            ":3: column 'rate_dph' stands twice, in fields 2 and 3; say which: --columns "
            "'rate=2[deg/h]' or 'rate=3[deg/h]'");
  EXPECT_EQ(fault("1,20,0.5\n2,20,0.5\n"),
            ":1: numbers where the column names should be; put a line such as "
            "time_s,temperature_degc,rate_dph before them, or give --columns "
            "'time=1[s],temperature=2[degC],rate=3[deg/h]'");
}

TEST(CsvReader, ProposesColumnsOfTheRightUnitWhateverTheirNames) {
  EXPECT_EQ(fault("Time [min],T_coil [K],T_hub [K],Rate [deg/h]\n0,293,293,1\n"),
            ":1: temperature could be column 2 'T_coil [K]' or column 3 'T_hub [K]'; say which: "
            "--columns 'temperature=T_coil [K]'");
}

// Renaming across units is an error by 3600, 1000 or 273: no message may propose it.
TEST(CsvReader, ProposesNoColumnOfAnotherUnit) {
  EXPECT_EQ(fault("time_s,temperature2_degc,rate_dph\n0,20,1\n"),
            ":1: no column 'temperature_degc'; the header has time_s, temperature2_degc, rate_dph; "
            "rename or add it, or say which it is: --columns temperature=NAME[degC]; without "
            "temperatures: --temperature DEGC");
  EXPECT_EQ(fault("time_s,temperature_degc,rate_x_dph,rate_y_dph,rate_z_dph\n0,20,1,2,3\n"),
            ":1: rate could be column 3 'rate_x_dph' or column 4 'rate_y_dph' or column 5 "
            "'rate_z_dph'; say which: --columns 'rate=rate_x_dph', or --rate-column 'rate_x_dph'");
}

TEST(CsvReader, RateOfTheTable_IsTheInputRate) {
  for (const std::string name : {"table_rate [deg/s]", "Turntable (deg/s)", "rate_table_dps"}) {
    const Recording recording =
        read_text("time_s,temperature_degc,rate_dph," + name + "\n0,20,1,3\n");
    EXPECT_EQ(recording.input_rate_dph, std::vector<double>{10800}) << name;
  }
}

TEST(CsvReader, ConvertsAnInputRateInAnotherUnit) {
  std::string said;
  const Recording recording = read_text(
      "time_s,temperature_degc,rate_dph,note,input_rate_dps\n0,20,1,2,3\n", heard_in(said));
  EXPECT_EQ(recording.input_rate_dph, std::vector<double>{10800});
  EXPECT_NE(said.find("column ignored: note\n"), std::string::npos) << said;
  EXPECT_NE(said.find("input_rate: column 5 'input_rate_dps' x 3600"), std::string::npos) << said;
}

TEST(CsvReader, SaysWhatIsWrongWithTheFile) {
  EXPECT_EQ(fault(""), ": is empty; is it the right file?");
  EXPECT_EQ(fault("# only a comment\n"),
            ": has no header line and no samples; is it the right file?");
  EXPECT_EQ(fault(kHeader), ": has a header but no samples");
  EXPECT_THROW(read_recording(::testing::TempDir(), {}), InputError);
  EXPECT_THROW(read_recording("/no/such/file.csv", {}), InputError);
  ReadOptions options;
  options.skip_bad_rows = true;
  EXPECT_EQ(fault(kHeader + "1,2\n", options),
            ": has no good row; the first bad one: line 2, 2 fields where the header has 3");
  EXPECT_EQ(fault(kHeader + std::string(2U << 20U, '1')),
            ":2: line longer than 1 MiB; is this a recording?");
}

TEST(CsvReader, RefusesTimesThatCannotBeSeconds) {
  EXPECT_EQ(fault(kHeader + "0,20,1\n5e6,20,1\n1e7,20,1\n"),
            ": samples are 5e+06 s apart; is the time in s? if not, give --columns time=NAME[us]");
}

TEST(CsvReader, NeverCrashesOnAMutatedFile) {
  std::string good = kHeader;
  for (int i = 0; i < 40; ++i) {
    good += std::to_string(i) + ".25," + std::to_string(20 + i) + ".5,0.123456\n";
  }
  const std::string alphabet = "0123456789.,-+eE\n\r\t #\"naif\xEF\xBB\xBF\xA5\x5A;";
  std::mt19937 random(1);
  int read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string mutated = good;
    for (unsigned change = 1 + random() % 4; change > 0; --change) {
      const std::size_t at = random() % mutated.size();
      switch (random() % 5) {
        case 0:
          mutated[at] = alphabet[random() % alphabet.size()];
          break;
        case 1:
          mutated.insert(at, 1, alphabet[random() % alphabet.size()]);
          break;
        case 2:
          mutated.erase(at, 1 + random() % 60);
          break;
        case 3:
          mutated.insert(at, mutated.substr(random() % mutated.size(), 30));
          break;
        default:
          mutated[at] = static_cast<char>(random());
          break;
      }
      if (mutated.empty()) mutated = "\n";
    }
    ReadOptions options;
    options.skip_bad_rows = random() % 2 == 0;
    try {
      const Recording recording = read_text(mutated, options);
      EXPECT_EQ(recording.rate_dph.size(), recording.rows());
      ++read;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(read, 500);
}

}  // namespace
}  // namespace fogcomp::recording
