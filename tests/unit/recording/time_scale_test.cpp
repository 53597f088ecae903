#include "recording/csv_layout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "unit/recording/heard_in.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp::recording {
namespace {

// 40 rows whose times are `first` + row * `step`, in a column of that name.
std::string file_with(const char* name, double first, double step, int decimals) {
  std::string text = std::string(name) + ",temperature_degc,rate_dph\n";
  for (int row = 0; row < 40; ++row) {
    text += format("%.*f,%d,%d\n", decimals, first + row * step, 20, row % 7);
  }
  return text;
}

// What is said of the file, or why it is refused; and its period.
struct Read {
  std::string said;
  double period_s = 0;
};

Read read(const std::string& content, const std::string& columns = "") {
  Read result;
  ReadOptions options = heard_in(result.said);
  options.columns = columns;
  try {
    result.period_s = read_recording(temporary_file("times.csv", content), options).period_s;
  } catch (const InputError& error) {
    result.said = error.what();
  }
  return result;
}

TEST(TimeScale, NumbersThatAreDates_InTheOnlyUnitThatFits) {
  struct Case {
    const char* name;
    double first;
    double step;
    int decimals;
    double period_s;
    const char* said;
  };
  const Case cases[] = {
      {"timestamp", 638452458150000000, 1e7, 0, 1, "as 100 ns"},
      {"timestamp", 638452458150000000, 1e7, 0, 1, ".NET times, counted from the first sample"},
      {"stamp_time", 133541298150000000, 5e4, 0, 0.005, "FILETIME times"},
      {"FileTime", 133541298150000000, 1e6, 0, 0.1, "FILETIME times"},
      {"Date", 45356.5, 1 / 86400.0, 9, 1, "as days"},
      {"time", 45356.5, 1 / 86400.0, 9, 1, "spreadsheet times"},
      {"time", 739316.5, 1 / 86400.0, 9, 1, "MATLAB times"},
      {"datenum", 739316.5, 5 / 86400.0, 9, 5, "MATLAB times"},
      {"julian_date", 2460375.0, 1 / 86400.0, 9, 1, "Julian times"},
      {"epoch", 1709625600, 1, 0, 1, "UNIX times"},
      {"timestamp", 1709625600000, 100, 0, 0.1, "as ms"},
      {"timestamp", 1709625600000000, 1e5, 0, 0.1, "as us"},
      {"timestamp", 1709625600000000000, 1e8, 0, 0.1, "as ns"},
      {"time", 45356.5, 0.1, 1, 0.1, "as s"},  // since power-on, or of the day
      {"time", 0, 1e-3, 3, 1e-3, "as s"},
      {"time", 0.5, 300, 1, 300, "as s"},
  };
  for (const Case& each : cases) {
    const Read result = read(file_with(each.name, each.first, each.step, each.decimals));
    EXPECT_NEAR(result.period_s, each.period_s, 1e-5 * each.period_s)
        << each.name << ' ' << each.said << ": " << result.said;
    EXPECT_NE(result.said.find(each.said), std::string::npos) << each.said << ": " << result.said;
  }
}

TEST(TimeScale, NumbersWithTwoMeanings_RefusedWithBoth) {
  // 200 Hz from 12.6 h on, or 7.2 min between dates of a spreadsheet.
  const std::string both = file_with("time", 45356.5, 0.005, 3);
  EXPECT_NE(
      read(both).said.find(
          "times such as 45356.5 (column 1 'time') can be in s since power-on, a sample each 0.005 "
          "s, or in days (spreadsheet dates), a sample each 432 s; say which: --columns "
          "'time=time[s]' or 'time=time[days]'"),
      std::string::npos)
      << read(both).said;
  EXPECT_EQ(read(both, "time=time[s]").period_s, 0.005);
  EXPECT_NEAR(read(both, "time=time[days]").period_s, 432, 1e-3);
  const Read minutes = read(file_with("datenum", 739316.5, 60 / 86400.0, 9));  // or 1.4 kHz
  EXPECT_NE(minutes.said.find("in days (MATLAB dates), a sample each 60 s"), std::string::npos)
      << minutes.said;
  const Read counter = read(file_with("time", 2e9, 5000, 0));  // since power-on
  EXPECT_NE(counter.said.find("--columns 'time=time[ms]' or 'time=time[us]'"), std::string::npos)
      << counter.said;
}

TEST(TimeScale, NumbersWithoutMeaning_RefusedWithTheOption) {
  const Read result = read(file_with("time", 5e18 / 2, 1e17, 0));
  EXPECT_NE(result.said.find("give no possible date or period in s, ms, us, ns, 100 ns or days; "
                             "give their unit: --columns 'time=time[UNIT]'"),
            std::string::npos)
      << result.said;
}

TEST(TimeScale, SecondsOfAnotherCalendar_AreNoTimeSincePowerOn) {
  const Read slow = read(file_with("timestamp", 731332800, 1, 1));  // 2024, since 2001
  EXPECT_NE(slow.said.find("can be in ms since power-on, a sample each 0.001 s, or in s (dates), a "
                           "sample each 1 s"),
            std::string::npos)
      << slow.said;
  const Read fast = read(file_with("timestamp", 731332800, 0.01, 2));
  EXPECT_NEAR(fast.period_s, 0.01, 1e-6) << fast.said;
  EXPECT_NE(fast.said.find("calendar times, counted from the first sample"), std::string::npos)
      << fast.said;
}

TEST(TimeScale, WholeNumbersThatMayBeMilliseconds_RefusedOrSaid) {
  const Read tens = read(file_with("time", 0, 10, 0));
  EXPECT_NE(tens.said.find("can be in s since power-on, a sample each 10 s, or in ms since "
                           "power-on, a sample each 0.01 s; say which"),
            std::string::npos)
      << tens.said;
  const Read ones = read(file_with("time", 0, 1, 0));
  EXPECT_EQ(ones.period_s, 1);
  EXPECT_NE(ones.said.find("column 1 'time' as s (in ms: a sample each 0.001 s)"),
            std::string::npos)
      << ones.said;
  EXPECT_EQ(read(file_with("time", 0.5, 10, 1)).said.find("in ms"), std::string::npos);
}

TEST(TimeScale, NumbersOfAClock_Refused) {
  std::string clock = "utc_time,temperature_degc,rate_dph\n";
  std::string seconds = clock;
  for (int row = 0; row < 200; ++row) {
    const int s = 43130 + row;
    clock += format("%02d%02d%02d,20,%d\n", s / 3600, s / 60 % 60, s % 60, row % 7);
    seconds += format("%d,20,%d\n", row + (row > 50 ? 40 : 0), row % 7);
  }
  EXPECT_NE(read(clock).said.find("times such as 115850 (column 1 'utc_time') are hhmmss of a "
                                  "clock; write 2024-03-05T12:30:15.25 or seconds"),
            std::string::npos)
      << read(clock).said;
  EXPECT_EQ(read(seconds).period_s, 1) << read(seconds).said;
}

TEST(TimeScale, UnitThatIsGiven_NotDoubted) {
  EXPECT_EQ(read(file_with("time [us]", 0, 4e9, 0)).period_s, 4000);
  EXPECT_EQ(read(file_with("time_s", 45356.5, 0.005, 3)).period_s, 0.005);
  const Read ticks = read(file_with("t", 5, 5e4, 0), "time=t[100 ns]");
  EXPECT_EQ(ticks.period_s, 0.005) << ticks.said;
}

std::vector<double> times_of(const std::string& content, const std::string& columns = "") {
  ReadOptions options;
  options.columns = columns;
  try {
    return read_recording(temporary_file("times.csv", content), options).time_s;
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what();
    return {};
  }
}

TEST(TimeOfTwoColumns, SecondsAndNanoseconds_Added) {
  const std::string rows =
      ",temperature_degc,rate_dph\n1709625600,999000000,20,1\n1709625601,4000000,20,2\n"
      "1709625601,9000000,20,1\n";
  for (const char* names :
       {"stamp.sec,stamp.nanosec", "header_stamp_secs,header_stamp_nsecs", "secs,nsecs"}) {
    const std::vector<double> time_s = times_of(names + rows);
    ASSERT_EQ(time_s.size(), 3U) << names;
    EXPECT_EQ(time_s[0], 0) << names;
    EXPECT_NEAR(time_s[1], 0.005, 1e-12) << names;
    EXPECT_NEAR(time_s[2], 0.010, 1e-12) << names;
  }
  EXPECT_NEAR(times_of("a,b" + rows, "time=a[s]+b[ns]").at(2), 0.010, 1e-12);
  EXPECT_NEAR(times_of("week,tow,temperature_degc,rate_dph\n2300,604799.5,20,1\n2301,0,20,2\n",
                       "time=week[weeks]+tow[s]")
                  .at(1),
              0.5, 1e-6);
}

TEST(TimeOfTwoColumns, SameTimeTwice_Refused) {
  const Read result = read(
      "elapsed_s,elapsed_ms,temperature_degc,rate_dph\n0.5,500,20,1\n1.0,1000,20,2\n1.5,1500,20,"
      "1\n");
  EXPECT_NE(result.said.find("'elapsed_s' and 'elapsed_ms' are no time in parts (whole "
                             "numbers, and less than one of them): say which is the time: "
                             "--columns 'time=elapsed_s' or 'time=elapsed_ms'"),
            std::string::npos)
      << result.said;
}

TEST(TimeOfSeveralColumns, HoursMinutesSeconds_Added) {
  const std::string rest = ",temperature_degc,rate_dph\n";
  const std::string rows = "0,59,59.5,20,1\n1,0,0.0,20,2\n1,0,0.5,20,1\n";
  const std::vector<double> expected{3599.5, 3600, 3600.5};
  for (const char* names : {"h,m,s", "HH,MM,SS", "hour,min,sec", "Hours,Minutes,Seconds", "h,min,s",
                            "hour,mm,sec", "time_h,time_m,time_s", "Time H,Time M,Time S"}) {
    EXPECT_EQ(times_of(names + rest + rows), expected) << names;
  }
  EXPECT_EQ(times_of("a,b,c" + rest + rows, "time=a[h]+b[min]+c[s]"), expected);
  for (const char* names : {"m,s", "min,s", "minute,second", "Time [min],Time [s]"}) {
    EXPECT_EQ(times_of(names + rest + "59,59.5,20,1\n60,0,20,2\n"), (std::vector{3599.5, 3600.0}))
        << names;
  }
  EXPECT_EQ(times_of("h,m" + rest + "1,59,20,1\n2,0,20,2\n"), (std::vector{7140.0, 7200.0}));
  EXPECT_EQ(times_of("second,ms" + rest + "1,999,20,1\n2,0,20,2\n"), (std::vector{1.999, 2.0}));
  EXPECT_EQ(times_of("s,m,h" + rest + "59.5,59,0,20,1\n0,0,1,20,2\n"),
            (std::vector<double>{3599.5, 3600}));
}

TEST(TimeOfSeveralColumns, DateBesideThem_CountsFromTheFirstSample) {
  const std::string rows =
      ",hour,min,sec,temperature_degc,rate_dph\n2024-02-29,23,59,59,20,1\n2024-03-01,0,0,0,20,2\n";
  EXPECT_EQ(times_of("date" + rows), (std::vector<double>{0, 1}));
  EXPECT_EQ(times_of("day" + rows, "time=day+hour[h]+min[min]+sec[s]"),
            (std::vector<double>{0, 1}));
}

// Over the end of a month, which a sum of days does not know.
TEST(TimeOfSeveralColumns, YearToSecond_IsADate) {
  const std::string rest = ",temperature_degc,rate_dph\n";
  for (const char* names :
       {"year,month,day,h,m,s", "Year,Month,Day,Hours,Minutes,Seconds",
        "UTC Year,UTC Month,UTC Day,UTC Hour,UTC Minute,UTC Second", "yyyy,mon,dd,hh,mm,ss"}) {
    EXPECT_EQ(times_of(names + rest + "2024,2,29,23,59,59,20,1\n2024,3,1,0,0,0.5,20,2\n"),
              (std::vector<double>{0, 1.5}))
        << names;
  }
  EXPECT_EQ(
      times_of("year,month,day,hour,min" + rest + "2023,12,31,23,59,20,1\n2024,1,1,0,0,20,2\n"),
      (std::vector<double>{0, 60}));
}

TEST(TimeOfSeveralColumns, TimeBesideACalendar_ComesFirst) {
  EXPECT_EQ(times_of("timestamp,utc_year,utc_month,utc_day,utc_hour,utc_minute,temperature_degc,"
                     "rate_dph\n0.5,2024,2,29,23,59,20,1\n1,2024,2,29,23,59,20,2\n"),
            (std::vector<double>{0.5, 1}));
}

TEST(TimeOfSeveralColumns, ClockThatMayNotCountFromPowerOn_Said) {
  const std::string names = "h,m,s,temperature_degc,rate_dph\n";
  EXPECT_NE(
      read(names + "8,0,0,20,1\n8,0,1,20,2\n").said.find("power-on is 28800 s before the first"),
      std::string::npos);
  EXPECT_EQ(read(names + "0,0,0,20,1\n0,0,1,20,2\n").said.find("power-on"), std::string::npos);
}

TEST(TimeOfSeveralColumns, PartThatIsNone_Refused) {
  const Read result =
      read("hour,min,sec,temperature_degc,rate_dph\n0,75,4500,20,1\n0,75,4501,20,2\n");
  EXPECT_NE(result.said.find("'hour' and 'min' and 'sec' are no time in parts"), std::string::npos)
      << result.said;
}

TEST(TimeColumn, CalledTime_BeforeOneWithAUnit) {
  EXPECT_EQ(read("time,loop_time_us,temperature_degc,rate_dph\n0,5,20,1\n1,900000,20,2\n").period_s,
            1);
  EXPECT_EQ(
      read("loop_time_us,Time [ms],temperature_degc,rate_dph\n0,5,20,1\n7,1005,20,2\n").period_s,
      1);
  const Read two = read("stamp_time,loop_time_us,temperature_degc,rate_dph\n0,5,20,1\n1,9,20,2\n");
  EXPECT_NE(
      two.said.find("time could be column 1 'stamp_time' or column 2 'loop_time_us'; say which"),
      std::string::npos)
      << two.said;
}

TEST(TimeColumn, DatesOfLoggers_Read) {
  for (const char* format_of :
       {"2024-3-5 1:02:%02d", "2024/03/05 01:02:%02d UTC", "2024-03-05T01:02:%02dZ",
        "2024.3.5 01:02:%02d GMT", "05-Mar-2024 01:02:%02d", "5 March 2024 1:02:%02d AM",
        "Mar 5 2024 13:02:%02d", "05.03.2024 01:02:%02d", "03/25/2024 1:02:%02d PM",
        "25/03/2024 01:02:%02d", "20240305T0102%02d", "202403050102%02d"}) {
    std::string text = "time,temperature_degc,rate_dph\n";
    for (int row = 0; row < 5; ++row) text += format(format_of, 3 + row) + ",20,1\n";
    EXPECT_EQ(read(text).period_s, 1) << format_of << ": " << read(text).said;
  }
  for (const char* other : {"05/03/24 01:02:03", "5.3.24 1:02", "12:30:15 PM", "13:02 AM",
                            "Tue Mar 05 12:00:00 2024", "2024-13-05 01:02:03"}) {
    const Read result = read(std::string("time,temperature_degc,rate_dph\n") + other + ",20,1\n");
    EXPECT_NE(result.said.find("is no date and time; write 2024-03-05T12:30:15.25"),
              std::string::npos)
        << result.said;
  }
}

TEST(TimeColumn, HoursMinutesSecondsFromZero_Read) {
  for (const bool is_long : {false, true}) {
    std::string text = "elapsed,temperature_degc,rate_dph\n";
    for (int row = 0; row < 2000; ++row) {
      const int s = row * (is_long ? 60 : 1);
      text += format("%d:%02d:%02d.0,20,%d\n", s / 3600, s / 60 % 60, s % 60, row % 7);
    }
    const Read result = read(text);
    EXPECT_EQ(result.period_s, is_long ? 60 : 1) << result.said;
    EXPECT_EQ(result.said.find("power-on is not known"), std::string::npos) << result.said;
  }
  const Read late = read("elapsed,temperature_degc,rate_dph\n0:00:00,20,1\n0:00:61,20,2\n");
  EXPECT_NE(late.said.find("no date and time"), std::string::npos) << late.said;
}

TEST(TimeColumn, DayOrMonthFirst_RefusedWithBoth) {
  const std::string text =
      "Stamp time,temperature_degc,rate_dph\n03/05/2024 23:00:00,20,1\n"
      "03/06/2024 01:00:00,20,2\n";
  EXPECT_NE(read(text).said.find("say which: --columns 'time=Stamp time[D/M/Y]' or "
                                 "'time=Stamp time[M/D/Y]'"),
            std::string::npos)
      << read(text).said;
  EXPECT_EQ(read(text, "time=Stamp time[M/D/Y]").period_s, 7200);
  const std::string said = read(text, "time=Stamp time[D/M/Y]").said;
  EXPECT_NE(said.find("2.5992e+06 s apart"), std::string::npos) << said;
}

TEST(TimeColumn, DateAndTimeOfDay_OneStamp) {
  const auto text = [](const char* names, const char* pattern) {
    std::string rows = std::string(names) + ",temperature_degc,rate_dph\n";
    for (int row = 0; row < 4; ++row) {
      rows += format(pattern, 5 + row / 2, row < 2 ? 23 : 0, row < 2 ? 58 + row : row - 2) +
              format(",20,%d\n", row);
    }
    return rows;
  };
  for (const char* pattern : {"2024-03-%02d,%02d:%02d:00", "%d.3.2024,%02d:%02d:00",
                              "202403%02d,%02d%02d00", "%02d-Mar-2024,%02d:%02d"}) {
    for (const char* names : {"Date,Time", "Datum,Uhrzeit"}) {
      const Read result = read(text(names, pattern));
      EXPECT_EQ(result.period_s, 60) << pattern << result.said;
      EXPECT_NE(result.said.find("time: column 1"), std::string::npos) << result.said;
    }
  }
  EXPECT_EQ(read(text("a,b", "2024-03-%02d,%02d:%02d:00"), "time=a+b").period_s, 60);
  const std::string slashes = text("Date,Time", "%02d/03/2024,%02d:%02d:00");
  EXPECT_NE(read(slashes).said.find("'time=Date[D/M/Y]+Time' or 'time=Date[M/D/Y]+Time'"),
            std::string::npos)
      << read(slashes).said;
  EXPECT_EQ(read(slashes, "time=Date[D/M/Y]+Time").period_s, 60);
}

TEST(TimeColumn, SecondTimes_RefusedIfTheyRunOtherwise) {
  const auto text = [](double every_s) {
    std::string rows = "Time [s],Rate [deg/h],Time2 [s],Temp [degC]\n";
    for (int row = 0; row < 40; ++row) rows += format("%d,%d,%g,20\n", row, row % 7, every_s * row);
    return rows;
  };
  EXPECT_NE(read(text(5)).said.find("put each into a file and give --join"), std::string::npos)
      << read(text(5)).said;
  EXPECT_EQ(read(text(5), "time=Time [s]").period_s, 1);
  EXPECT_EQ(read(text(1.0001)).period_s, 1);
}

// Beside a column with a recording's own name: in parts, or the same once more.
TEST(TimeColumn, PartOfTheTimeInAnother_AskedFor) {
  const auto text = [](const char* names, bool are_parts, double finer) {
    std::string rows = names + std::string(",temperature_degc,rate_dph\n");
    for (int row = 0; row < 200; ++row) {
      const double coarse = row / 5.0;
      rows += are_parts ? format("%g,%g,20,%d\n", std::floor(coarse), row % 5 * finer / 5, row % 7)
                        : format("%g,%g,20,%d\n", coarse, coarse * finer, row % 7);
    }
    return rows;
  };
  EXPECT_NE(read(text("time_min,time_s", true, 60))
                .said.find("its time is in parts, 'time_s' and 'time_min'; give both: --columns "
                           "'time=time_min+time_s'"),
            std::string::npos);
  EXPECT_NE(read(text("time_s,time_ms", true, 1000)).said.find("'time=time_s+time_ms'"),
            std::string::npos);
  EXPECT_EQ(read(text("time_min,time_s", false, 60)).period_s, 12);
  EXPECT_EQ(read(text("time_s,time_ms", false, 1000)).period_s, 0.2);
}

TEST(TimeCounter, ThatBeginsAgain_CountedOn) {
  struct Case {
    const char* name;
    double span;  // counts
    double first;
    double step;
    double period_s;
  };
  for (const Case& each :
       {Case{"time_us", 4294967296, 4294900000, 5000, 0.005},
        Case{"time_ms", 65536, 65000, 10, 0.01},
        Case{"time_us", 4294967296, 2147400000, 5000, 0.005}, Case{"time_s", 86400, 86350, 1, 1},
        Case{"tow_time_s", 604800, 604750, 1, 1}}) {
    std::string text = std::string(each.name) + ",temperature_degc,rate_dph\n";
    for (int row = 0; row < 200; ++row) {
      double count = std::fmod(each.first + row * each.step, each.span);
      // the last one has a sign
      if (each.first < 3e9 && each.first > 1e9 && count >= each.span / 2) count -= each.span;
      text += format("%.0f,20,%d\n", count, row % 7);
    }
    const Read result = read(text);
    EXPECT_EQ(result.period_s, each.period_s) << result.said;
    EXPECT_NE(result.said.find("its time counter began again"), std::string::npos) << result.said;
  }
  std::string restarted = "time_us,temperature_degc,rate_dph\n";
  for (int row = 0; row < 200; ++row) restarted += format("%d,20,%d\n", row % 100 * 5000, row % 7);
  EXPECT_NE(read(restarted).said.find("time_s begins again"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::recording
