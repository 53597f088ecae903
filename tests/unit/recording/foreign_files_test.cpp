// Files as written by laboratories: read correctly, value by value, or refused with a helpful line.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "heard_in.hpp"
#include "recording/columns.hpp"
#include "recording/recording.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "temporary_file.hpp"

namespace fogcomp::recording {
namespace {

constexpr int kRows = 40;

double true_time_s(int row) {
  return 0.25 + 0.5 * row;
}
double true_temperature_degc(int row) {
  return 21.5 + 0.125 * row;
}
double true_rate_dph(int row) {
  return 7.25 + 0.5 * ((row * 7) % 11);
}

std::string digits(double value) {
  return format("%.17g", value);
}

// Format of a file; by default the plain format.
struct FileWriter {
  using Print = std::function<std::string(int row)>;
  struct FileColumn {
    std::string name;
    Print print;
    std::string unit{};  // for a row of units
  };
  std::string separator = ",";
  bool decimal_comma = false;
  std::string line_end = "\n";
  std::string preamble{};
  bool units_row = false;
  bool quotes = false;
  bool comment_header = false;
  bool separator_behind_names = false;
  bool separator_behind_rows = false;
  bool time_from_first_row = false;
  FileColumn time{"time_s", [](int row) { return digits(true_time_s(row)); }, "s"};
  FileColumn temperature{"temperature_degc",
                         [](int row) { return digits(true_temperature_degc(row)); }, "degC"};
  FileColumn rate{"rate_dph", [](int row) { return digits(true_rate_dph(row)); }, "deg/h"};
  std::vector<FileColumn> others{};
  std::function<std::string(std::string)> encode = [](std::string text) { return text; };
  ReadOptions options{};

  std::string field(std::string text, bool number) const {
    if (decimal_comma && number) {
      for (char& c : text) c = c == '.' ? ',' : c;
    }
    return quotes ? "\"" + text + "\"" : text;
  }
  std::string line(const std::function<std::string(const FileColumn&)>& of, bool numbers) const {
    std::string text = field(of(time), numbers);
    for (const FileColumn* each : {&temperature, &rate})
      text += separator + field(of(*each), numbers);
    for (const FileColumn& each : others) text += separator + field(of(each), numbers);
    const bool is_behind = numbers ? separator_behind_rows : separator_behind_names;
    const bool may_be = separator.find_first_not_of(' ') != std::string::npos;
    return text + (is_behind && may_be ? separator : "") + line_end;
  }
  std::string content() const {
    std::string text = preamble + (comment_header ? "# " : "");
    text += line([](const FileColumn& each) { return each.name; }, false);
    if (units_row) text += line([](const FileColumn& each) { return each.unit; }, false);
    for (int row = 0; row < kRows; ++row) {
      text += line([row](const FileColumn& each) { return each.print(row); }, true);
    }
    return encode(text);
  }
};

std::string utf16(const std::string& text, bool little) {
  std::string units;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = static_cast<unsigned char>(text[i]);
    if (code >= 0xC0U) {
      code = ((code & 0x1FU) << 6U) | (static_cast<unsigned char>(text[++i]) & 0x3FU);
    }
    const char low = static_cast<char>(code & 0xFFU);
    const char high = static_cast<char>(code >> 8U);
    units += little ? std::string{low, high} : std::string{high, low};
  }
  return units;
}

std::string latin1(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (static_cast<unsigned char>(text[i]) == 0xC2U) ++i;
    bytes += text[i];
  }
  return bytes;
}

// A deviation from the plain format. A file has at most one of each kind.
struct Property {
  const char* kind;
  const char* name;
  std::function<void(FileWriter&)> apply;
};

Property named_unit(const char* kind, const char* name, FileWriter::FileColumn FileWriter::*column,
                    FileWriter::Print print) {
  return {kind, name, [=](FileWriter& file) {
            (file.*column).name = name;
            (file.*column).unit = "";
            (file.*column).print = print;
          }};
}

Property time_in(const char* name, double per_second) {
  return named_unit("time", name, &FileWriter::time,
                    [=](int row) { return digits(true_time_s(row) * per_second); });
}
Property kelvin(const char* name) {
  return named_unit("temperature", name, &FileWriter::temperature,
                    [](int row) { return digits(true_temperature_degc(row) + 273.15); });
}
Property fahrenheit(const char* name) {
  return named_unit("temperature", name, &FileWriter::temperature,
                    [](int row) { return digits(true_temperature_degc(row) * 1.8 + 32); });
}
Property celsius(const char* name) {
  return named_unit("temperature", name, &FileWriter::temperature,
                    [](int row) { return digits(true_temperature_degc(row)); });
}
Property rate_in(const char* name, double per_dph) {
  return named_unit("rate", name, &FileWriter::rate,
                    [=](int row) { return digits(true_rate_dph(row) * per_dph); });
}
Property unix_time(const char* name, double per_second, int decimals) {
  return {"time", name, [=](FileWriter& file) {
            file.time_from_first_row = true;
            file.time.name = name;
            file.time.unit = "";
            file.time.print = [=](int row) {
              // As text, because a double has too few digits.
              const long long whole = 1'709'625'600LL * static_cast<long long>(per_second) +
                                      std::llround(0.5 * row * per_second);
              if (decimals == 0) return std::to_string(whole);
              return format("%lld.%02d", 1'709'625'600LL + row / 2, 50 * (row % 2));
            };
          }};
}
Property calendar(const char* label, const char* name, const char* pattern) {
  return {"time", label, [=](FileWriter& file) {
            file.time_from_first_row = true;
            file.time.name = name;
            file.time.unit = "";
            file.time.print = [=](int row) {
              return format(pattern, 30 + (row / 2) / 60, (row / 2) % 60, 5 * (row % 2));
            };
          }};
}

constexpr double kDpsPerDph = 1.0 / 3600;
constexpr double kRadpsPerDph = 3.14159265358979323846 / 180 / 3600;

std::vector<Property> properties() {
  std::vector<Property> all{
      {"separator", "semicolon", [](FileWriter& file) { file.separator = ";"; }},
      {"separator", "tab", [](FileWriter& file) { file.separator = "\t"; }},
      {"separator", "blank", [](FileWriter& file) { file.separator = " "; }},
      {"separator", "blanks", [](FileWriter& file) { file.separator = "   "; }},
      {"separator", "comma and blank", [](FileWriter& file) { file.separator = ", "; }},
      {"decimals", "decimal comma", [](FileWriter& file) { file.decimal_comma = true; }},
      {"lines", "CRLF", [](FileWriter& file) { file.line_end = "\r\n"; }},
      {"lines", "blank lines", [](FileWriter& file) { file.line_end = "\n\n"; }},
      {"preamble", "# comments",
       [](FileWriter& file) { file.preamble = "# chamber 3, run 12\n#\n"; }},
      {"preamble", "% comments",
       [](FileWriter& file) { file.preamble = "% time, temperature, rate of run 12\n"; }},
      {"preamble", "free lines",
       [](FileWriter& file) {
         file.preamble = "Device: FOG-7\nSerial;12\nExport of time, temperature, rate\n\n";
       }},
      {"preamble",
       "sep=", [](FileWriter& file) { file.preamble = "sep=" + file.separator + "\n"; }},
      {"preamble", "names in a comment", [](FileWriter& file) { file.comment_header = true; }},
      {"units", "row of units", [](FileWriter& file) { file.units_row = true; }},
      {"quotes", "quotes", [](FileWriter& file) { file.quotes = true; }},
      {"encoding", "BOM",
       [](FileWriter& file) {
         file.encode = [](const std::string& text) { return "\xEF\xBB\xBF" + text; };
       }},
      {"encoding", "UTF-16 LE",
       [](FileWriter& file) {
         file.encode = [](const std::string& text) { return "\xFF\xFE" + utf16(text, true); };
       }},
      {"encoding", "UTF-16 BE",
       [](FileWriter& file) {
         file.encode = [](const std::string& text) { return "\xFE\xFF" + utf16(text, false); };
       }},
      {"encoding", "UTF-16 without mark",
       [](FileWriter& file) {
         file.encode = [](const std::string& text) { return utf16(text, true); };
       }},
      {"encoding", "Latin-1", [](FileWriter& file) { file.encode = latin1; }},
      {"others", "index and accelerations",
       [](FileWriter& file) {
         file.others = {{"acc_x [m/s2]", [](int) { return "9.81"; }, "m/s2"},
                        {"count", [](int row) { return std::to_string(row); }, "-"}};
       }},
      {"others", "a separator behind each line",
       [](FileWriter& file) { file.separator_behind_names = file.separator_behind_rows = true; }},
      {"others", "a separator behind each row",
       [](FileWriter& file) { file.separator_behind_rows = true; }},
      {"others", "a separator behind the header",
       [](FileWriter& file) { file.separator_behind_names = true; }},
      time_in("Time_s", 1),
      time_in("TIME [s]", 1),
      time_in("time_ms", 1e3),
      time_in("t_us", 1e6),
      time_in("Elapsed(ms)", 1e3),
      time_in("TimeUS", 1e6),
      time_in("time [\xC2\xB5s]", 1e6),
      time_in("Zeit_in_s", 1),
      time_in("timestamp_ns", 1e9),
      time_in("time/min", 1.0 / 60),
      time_in("time_h", 1.0 / 3600),
      unix_time("Timestamp [s]", 1, 2),
      unix_time("time_s", 1, 2),
      unix_time("unix_ms", 1e3, 0),
      unix_time("Epoch(ns)", 1e9, 0),
      unix_time("timestamp", 1e6, 0),
      calendar("ISO 8601", "time", "2024-02-29T23:%02d:%02d.%d00"),
      calendar("ISO 8601 with zone", "DateTime", "2024-02-29T23:%02d:%02d.%d+01:00"),
      calendar("ISO 8601 over midnight", "utc", "2024-02-29T23:%02d:%02d.%dZ"),
      celsius("Temp"),
      celsius("T"),
      celsius("T [\xC2\xB0"
              "C]"),
      celsius("coil_temp(degC)"),
      celsius("Temperatur/\xC2\xB0"
              "C"),
      kelvin("T [K]"),
      kelvin("temperature_k"),
      fahrenheit("Temp (degF)"),
      fahrenheit("temperature [\xC2\xB0"
                 "F]"),
      rate_in("rate_dps", kDpsPerDph),
      rate_in("Gyro_X[deg/s]", kDpsPerDph),
      rate_in("GyroZ[\xC2\xB0/s]", kDpsPerDph),
      rate_in("omega_deg_per_s", kDpsPerDph),
      rate_in("mdps", 1e3 * kDpsPerDph),
      rate_in("rate_dpm", 1.0 / 60),
      rate_in("w(rad/s)", kRadpsPerDph),
      rate_in("imu.gyro.x[rad*s^-1]", kRadpsPerDph),
      rate_in("GYRO_RADPS", kRadpsPerDph),
      rate_in("rate[\xC2\xB0/h]", 1),
      rate_in("RATE_DPH", 1),
  };
  return all;
}

void expect_true(const FileWriter& file, const std::string& name) {
  Recording recording;
  try {
    recording = read_recording(temporary_file("foreign.csv", file.content()), file.options);
  } catch (const InputError& error) {
    ADD_FAILURE() << name << ": " << error.what() << "\n" << file.content().substr(0, 300);
    return;
  }
  ASSERT_EQ(recording.rows(), static_cast<std::size_t>(kRows)) << name;
  EXPECT_EQ(recording.power_on_unknown, file.time_from_first_row) << name;
  for (int row = 0; row < kRows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const double begin_s = file.time_from_first_row ? true_time_s(0) : 0;
    EXPECT_NEAR(recording.time_s[i], true_time_s(row) - begin_s, 1e-9) << name;
    EXPECT_NEAR(recording.temperature_degc[i], true_temperature_degc(row), 1e-9) << name;
    EXPECT_NEAR(recording.rate_dph[i], true_rate_dph(row), 1e-9) << name;
    if (::testing::Test::HasFailure()) return;
  }
}

// A comma with two meanings can only be refused.
bool is_impossible(const FileWriter& file) {
  const bool comma = file.separator[0] == ',';
  return comma && file.decimal_comma && !file.quotes;
}

void expect_refused(const FileWriter& file, const std::string& name) {
  EXPECT_THROW(read_recording(temporary_file("foreign.csv", file.content()), file.options),
               InputError)
      << name;
}

void expect_right_or_refused(const FileWriter& file, const std::string& name) {
  if (is_impossible(file)) return expect_refused(file, name);
  expect_true(file, name);
}

TEST(ForeignFiles, AreReadValueByValueWithOneProperty) {
  const std::vector<Property> all = properties();
  EXPECT_GE(all.size(), 50U);
  for (const Property& property : all) {
    FileWriter file;
    property.apply(file);
    expect_right_or_refused(file, property.name);
  }
}

TEST(ForeignFiles, AreReadValueByValueWithEveryPairOfProperties) {
  const std::vector<Property> all = properties();
  std::size_t pairs = 0;
  for (const Property& one : all) {
    for (const Property& other : all) {
      if (&one >= &other || std::string(one.kind) == other.kind) continue;
      FileWriter file;
      one.apply(file);
      other.apply(file);
      // A name with a blank in it has to be quoted where blanks separate.
      if (file.separator[0] == ' ') file.quotes = true;
      ++pairs;
      expect_right_or_refused(file, std::string(one.name) + " and " + other.name);
      if (HasFailure()) return;
    }
  }
  EXPECT_GE(pairs, 500U);
}

struct RefusedFile {
  const char* name;
  const char* content;
  const char* said;
};

std::string said_of(const std::string& content, const ReadOptions& options = {}) {
  try {
    read_recording(temporary_file("foreign.csv", content), options);
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::size_t file = message.find("foreign.csv");
    return file == std::string::npos ? message : message.substr(file + 11);
  }
  return "no error";
}

TEST(ForeignFiles, AreRefusedWithTheLineThatHelpsWhereTheyMeanTwoThings) {
  const RefusedFile refusals[] = {
      {"two rates", "time_s,temperature_degc,gx [deg/s],gy [deg/s]\n0,20,1,2\n",
       ":1: rate could be column 3 'gx [deg/s]' or column 4 'gy [deg/s]'; say which: --columns "
       "'rate=gx [deg/s]', or --rate-column 'gx [deg/s]'"},
      {"rate without a unit", "time_s,temperature_degc,Gyro_X\n0,20,1\n",
       ":1: column 3 'Gyro_X' has no unit; give it: --columns 'rate=Gyro_X[deg/s or rad/s?]'"},
      {"turns or radians", "time_s,temperature_degc,gyro_rps\n0,20,1\n", "has no unit; give it"},
      {"two temperatures", "time_s,coil_degC,board_degC,rate_dph\n0,20,21,1\n",
       ":1: temperature could be column 2 'coil_degC' or column 3 'board_degC'; say which: "
       "--columns 'temperature=coil_degC'"},
      {"two times", "date,stamp_time,temperature_degc,rate_dph\n0,1,20,1\n",
       "time could be column 1"},
      {"unit against unit", "time_s,temperature_degc,rate_dph\ns,degC,deg/s\n0,20,1\n1,20,2\n",
       "'rate_dph' is in deg/h by its name and in deg/s by the units beside it"},
      {"unknown unit", "time_s,T [Ra],rate_dph\n0,20,1\n",
       "column 2 'T [Ra]': unit 'Ra' is not known; give it: --columns 'temperature=2[UNIT]', of "
       "degC, K, "
       "degF, degR, mdegC, cdegC or a multiple such as 0.1 degC"},
      {"time of day", "time,temperature_degc,rate_dph\n12:30:15,20,1\n12:30:16,20,1\n",
       ":2: time '12:30:15' is no date and time; write 2024-03-05T12:30:15.25 or seconds"},
      {"two digits of a year", "time,temperature_degc,rate_dph\n05.03.24 12:30,20,1\n",
       "is no date and time"},
      {"comma twice", "time_s,temperature_degc,rate_dph\n0,5,20,1,1,5\n1,5,20,1,1,5\n",
       ":2: 6 fields where the header has 3 (a ',' within numbers? separate columns by ';')"},
      {"too few digits", "unix_s,temperature_degc,rate_dph\n1.7097e9,20,1\n1.7097e9,20,2\n",
       ":3: time repeats, 0 s from the first sample; has it enough digits?"},
      {"no header", "0\t20\t1\n1\t20\t1\n",
       "put a line such as time_s,temperature_degc,rate_dph before them, or give --columns "
       "'time=1[s],temperature=2[degC],rate=3[deg/h]'"},
      {"no rate", "Time [s];Temp [degC]\n0;20\n1;20\n", "no column 'rate_dph'"},
      {"counts", "time_s;temperature_degc;gyro_counts\n0;20;1\n", "without a scale factor"},
      {"no temperature", "time_s,temperature_degc,rate_dph\n0,,1\n1,NaN,2\n",
       "temperature_degc has no value in any sample"},
  };
  for (const RefusedFile& each : refusals) {
    EXPECT_NE(said_of(each.content).find(each.said), std::string::npos)
        << each.name << ": " << said_of(each.content);
  }
}

// Forty rows whose last column is `first` and `second` in turn.
std::string table_of(const std::string& header, char separator, const std::string& first,
                     const std::string& second) {
  std::string text = header + "\n";
  for (int row = 0; row < kRows; ++row) {
    text +=
        std::to_string(row) + separator + "20" + separator + (row % 2 == 0 ? first : second) + "\n";
  }
  return text;
}

TEST(DigitGroups, NumbersThatMayBeDecimals_RefusedWithBoth) {
  ReadOptions options;
  options.scale_factor = 1800;  // a count is 2 deg/h
  const auto read = [&](const std::string& content) {
    return read_recording(temporary_file("groups.csv", content), options).rate_dph[0] / 2;
  };
  const std::string names = "time_s;temperature_degc;counts";
  for (const auto& [first, second, said] :
       {std::tuple("12,389", "12,402",
                   "numbers such as 12,389 (column 3 'counts') can be 12.389 or 12389; say which "
                   "mark is the decimal one: --decimal-mark comma or point"),
        std::tuple("12.389", "999",
                   "can be 12.389 or 12389; say which mark is the decimal one: "
                   "--decimal-mark point or comma"),
        std::tuple("-12,389", "+1,402", "can be 12.389 or 12389")}) {
    const std::string refusal = said_of(table_of(names, ';', first, second), options);
    EXPECT_NE(refusal.find(said), std::string::npos) << refusal;
  }
  const std::string quoted =
      table_of("time_s,temperature_degc,counts", ',', "\"12,389\"", "\"12,402\"");
  EXPECT_NE(said_of(quoted, options).find("can be 12.389 or 12389"), std::string::npos);
  // A zero before the mark, another number of digits, or a long number: decimals.
  EXPECT_NEAR(read(table_of(names, ';', "12,389", "0,402")), 12.389, 1e-9);
  EXPECT_NEAR(read(table_of(names, ';', "12,389", "7,5")), 12.389, 1e-9);
  EXPECT_NEAR(read(table_of(names, ';', "12,389", "2345")), 12.389, 1e-9);
  EXPECT_EQ(read_recording(temporary_file("groups.csv", table_of("time_s,temperature_degc,rate_dph",
                                                                 ',', "12.389", "13.402")),
                           {})
                .rate_dph[0],
            12.389);
  EXPECT_NE(said_of(table_of("time_s,temperature_degc,counts", ',', "12.389", "13.402"), options)
                .find("can be 12.389 or 12389"),
            std::string::npos);

  options.decimal_comma = false;
  EXPECT_NEAR(read(table_of(names, ';', "12,389", "1,234,567.5")), 12389, 1e-9);
  EXPECT_NEAR(read(quoted), 12389, 1e-9);
  options.decimal_comma = true;
  EXPECT_NEAR(read(table_of(names, ';', "12,389", "13,402")), 12.389, 1e-9);
  EXPECT_NEAR(read(table_of(names, ';', "12.389", "13.402")), 12389, 1e-9);
  EXPECT_NE(said_of(table_of(names, ';', "1.38", "1.40"), options).find("not a finite number"),
            std::string::npos);
}

TEST(ForeignFiles, ScaledUnit_NotTakenForTheUnit) {
  for (const char* name :
       {"rate_0.01 deg/s", "rate x10 dps", "rate_1e-6 rad/s", "rate 10^-6 rad/s", "rate*100_dps"}) {
    const std::string said = said_of("time_s,temperature_degc," + std::string(name) + "\n0,20,1\n");
    EXPECT_NE(said.find("give it: --columns 'rate="), std::string::npos) << name << said;
  }
  EXPECT_EQ(read_recording(temporary_file("milli.csv", "time_s,temp_mC,rate_dph\n0,20000,1\n"), {})
                .temperature_degc,
            std::vector<double>{20});
  EXPECT_EQ(read_recording(temporary_file("two.csv", "time_s,coilTempC,gyro_2_dps\n0,20,1\n"), {})
                .rate_dph,
            std::vector<double>{3600});
}

TEST(ForeignFiles, FactorInAName_AskedForItsUnit) {
  for (const char* name :
       {"rate x1000 [deg/h]", "rate*1000 [deg/h]", "1000*rate [deg/h]", "rate (x1e3) [deg/h]",
        "rate \xC3\x97 1000 [deg/h]", "10^3 rate [deg/h]", "rate_x1000_dph"}) {
    const std::string text = std::string("time_s,temp_degC,") + name + "\n0,20,1\n1,20,2\n";
    EXPECT_NE(said_of(text).find("'rate=3[0.001 deg/h]', 'rate=3[1000 deg/h]', or 'rate=3[deg/h]'"),
              std::string::npos)
        << said_of(text);
    ReadOptions options;
    options.columns = "rate=3[0.001 deg/h]";
    EXPECT_EQ(read_recording(temporary_file("factor.csv", text), options).rate_dph,
              (std::vector<double>{0.001, 0.002}));
  }
  for (const char* name : {"temp_x10", "Temp*2 [degC]", "T/10 [degC]", "Temp [degC] x10"}) {
    const std::string text = std::string("time_s,") + name + ",rate_dph\n0,20,1\n1,20,2\n";
    EXPECT_NE(said_of(text).find("has a factor"), std::string::npos) << said_of(text);
  }
  for (const char* name : {"gyro_x1 [deg/h]", "Gyro.10.x [deg/h]", "imu/12/gyro [deg/h]"}) {
    EXPECT_EQ(said_of(std::string("time_s,temp_degC,") + name + "\n0,20,1\n"), "no error");
  }
}

TEST(ForeignFiles, DashBeforeAUnit_NoMinus) {
  const auto rate_of = [](const std::string& name) {
    return read_recording(temporary_file("dash.csv", "time_s,temp_degC," + name + "\n0,20,1\n"), {})
        .rate_dph[0];
  };
  for (const char* name : {"Gyro rate - deg/h", "rate - dph", "rate-dph", "Omega-Z - \xC2\xB0/h",
                           "Rate \xE2\x88\x92 deg/h", "Rate \xE2\x80\x93 deg/h"}) {
    EXPECT_EQ(rate_of(name), 1) << name;
  }
  EXPECT_EQ(rate_of("rate [-deg/h]"), -1);
  for (const char* name : {"rate -dph", "rate [- deg/h]"}) {
    const std::string said = said_of(std::string("time_s,temp_degC,") + name + "\n0,20,1\n");
    EXPECT_NE(said.find("--columns 'rate=3["), std::string::npos) << said;
  }
}

TEST(ForeignFiles, UnitOfATemperature_AsItsWordsSay) {
  const auto degc_of = [](const std::string& name, const char* value) {
    const std::string text = "time_s," + name + ",rate_dph\n0," + value + ",1\n";
    return read_recording(temporary_file("unit.csv", text), {}).temperature_degc[0];
  };
  EXPECT_NEAR(degc_of("temperature [degrees Fahrenheit]", "68"), 20, 1e-9);
  EXPECT_NEAR(degc_of("temp [degR]", "527.67"), 20, 1e-9);
  EXPECT_NEAR(degc_of("T [0.1 degC]", "200"), 20, 1e-9);
  EXPECT_NEAR(degc_of("T [0.1 K]", "2931.5"), 20, 1e-9);
  EXPECT_NEAR(degc_of("temp,unit", "293.15,K"), 20, 1e-9);
  for (const char* name : {"temperature [C/10]", "temperature [R]"}) {
    const std::string said = said_of(std::string("time_s,") + name + ",rate_dph\n0,20,1\n");
    EXPECT_NE(said.find("is not known; give it: --columns 'temperature=2[UNIT]', of degC"),
              std::string::npos)
        << said;
    EXPECT_EQ(said.find("[degC]"), std::string::npos) << said;
  }
}

TEST(ForeignFiles, SetPointOrScatter_NoTemperature) {
  EXPECT_NE(said_of("time_s,Target Temp,Actual,rate_dph\n0,20,21,1\n")
                .find("no column 'temperature_degc'"),
            std::string::npos);
  EXPECT_EQ(
      read_recording(temporary_file("std.csv", "time_s,temp_std,temp,rate_dph\n0,0.1,20,1\n"), {})
          .temperature_degc,
      std::vector<double>{20});
}

TEST(ForeignFiles, UnicodeMinus_Read) {
  EXPECT_EQ(read_recording(temporary_file("minus.csv",
                                          "time_s,temp_degC,rate_dph\n0,\xE2\x88\x92"
                                          "20,\xE2\x88\x92"
                                          "1.5\n"),
                           {})
                .rate_dph,
            std::vector<double>{-1.5});
}

TEST(ForeignFiles, ApostropheInAName_NumberProposed) {
  EXPECT_NE(said_of("time_s,temperature_degc,it's rate [deg/h],rate_y [deg/h]\n0,20,1,2\n")
                .find("--columns 'rate=3[deg/h]'"),
            std::string::npos);
}

TEST(ForeignFiles, MergedLoggers_TemperatureKept) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 100; ++row) {
    if (row % 10 == 0) text += format("%d.5,%d,\n", row - 1, 20 + row / 10);
    text += format("%d,,%d\n", row, row % 7);
  }
  std::string said;
  const Recording recording = read_recording(temporary_file("outer.csv", text), heard_in(said));
  EXPECT_EQ(recording.rows(), 100U);
  EXPECT_EQ(recording.temperature_degc[10], 21);
  EXPECT_NE(said.find("10 rows without a rate: the other values count from the next sample on"),
            std::string::npos)
      << said;
}

TEST(ForeignFiles, TemperatureEachTwoMinutes_KnownBetween) {
  std::string text = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row <= 240; ++row) {
    text += format("%d,%s,%d\n", 10 * row, row % 12 == 0 ? digits(20 + 0.01 * row).c_str() : "",
                   row % 7);
  }
  const Recording recording = read_recording(temporary_file("slow.csv", text), {});
  EXPECT_EQ(recording.rows(), 241U);
  EXPECT_NEAR(recording.temperature_degc[6], 20.06, 1e-9);
}

TEST(ForeignFormats, FirstBytes_RefusedWithTheWayToACsv) {
  using namespace std::string_literals;
  struct Format {
    std::string start;
    const char* said;
  };
  const Format formats[] = {
      {"\x1F\x8B\x08", "gzip; give it unpacked: zcat FILE | fogcomp ... -"},
      {"BZh9", "bzcat"},
      {"\xFD"
       "7zXZ",
       "xzcat"},
      {"\x28\xB5\x2F\xFD\x04", "is compressed by zstd; give it unpacked: zstd -d"},
      {"PK\x03\x04", "save the sheet as CSV"},
      {"MATLAB 5.0 MAT-file, Platform: GLNXA64", "is a MATLAB file; make a CSV of it: octave "},
      {"MATLAB 7.3 MAT-file, Platform: GLNXA64", "is a MATLAB 7.3 file (HDF5); "},
      {"\x89HDF\r\n\x1A\n", "is an HDF5 file; make a CSV of it: fogcomp convert "},
      {"#ROSBAG V2.0\n", "is a ROS bag; make a CSV of it: fogcomp convert "},
      {"\x89MCAP0\r\n", "is an MCAP file; "},
      {"SQLite format 3\0"s, "is a database (a ROS 2 bag?); "},
      {"ULog\x01\x12\x35\x01", "is a ULog of PX4; make a CSV of it: fogcomp convert "},
      {"\xA3\x95\x80\x80\x59", "is a log of ArduPilot; make a CSV of it: mavlogdump.py"},
      {"TDSm\x0E", "is a TDMS file; "},
      {"\x93NUMPY\x01", "is an array of NumPy; "},
      {"PAR1\x15", "is a Parquet file; "},
      {"RDX3\nX\n", "is a file of R; "},
      {"000001D XX12345", "is a miniSEED file; "},
      {"MS\x03\x04", "is a miniSEED file; "},
  };
  for (const Format& each : formats) {
    for (const std::size_t more : {0U, 5000U}) {
      const std::string said = said_of(each.start + std::string(more, '\0'));
      EXPECT_NE(said.find(each.said), std::string::npos) << each.said << " | " << said;
    }
  }
}

TEST(ForeignFiles, AreSettledByTheMapOfColumns) {
  const std::string content =
      "Stamp\tTemp\tGyro_X\tGyro_Y [deg/s]\n1000\t293.15\t1e-3\t2\n1500\t294.15\t2e-3\t3\n";
  ReadOptions options;
  options.columns = "time=stamp[ms],temperature=Temp[K],rate=gyro_x[rad/s]";
  const Recording recording = read_recording(temporary_file("map.csv", content), options);
  EXPECT_EQ(recording.time_s, (std::vector<double>{1, 1.5}));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{20, 21}));
  EXPECT_NEAR(recording.rate_dph[0], 1e-3 / kRadpsPerDph, 1e-9);

  options.columns = "time=1[ms],temperature=2[K],rate=Gyro_Y";
  EXPECT_EQ(read_recording(temporary_file("map.csv", content), options).rate_dph,
            (std::vector<double>{7200, 10800}));
  options.columns = "time=1[s],temperature=2[degC],rate=3[deg/h]";
  EXPECT_EQ(read_recording(temporary_file("map.csv", "0 20 1\n1 21 2\n"), options).rate_dph,
            (std::vector<double>{1, 2}));

  ReadOptions remembered;
  remembered.model_columns = "time=stamp[ms],temperature=Temp[K],rate=gyro_x[rad/s]";
  EXPECT_EQ(read_recording(temporary_file("map.csv", content), remembered).time_s,
            (std::vector<double>{1, 1.5}));
  const std::string plain = "time_s,temperature_degc,rate_dph\n0,20,1\n";
  EXPECT_EQ(read_recording(temporary_file("map.csv", plain), remembered).rate_dph,
            std::vector<double>{1});
}

TEST(ColumnMap, ValueInPlaceOfAName_IsOfAllRows) {
  const std::string path = temporary_file("dwell.csv", "time_s,rate_dph,x\n0,1,7\n1,2,8\n");
  std::string said;
  ReadOptions options = heard_in(said);
  options.columns = "input_rate=50[deg/s],temperature=298.15[K]";
  const Recording recording = read_recording(path, options);
  EXPECT_EQ(recording.input_rate_dph, (std::vector<double>{180000, 180000}));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{25, 25}));
  EXPECT_EQ(recording.temperature_period_s, HUGE_VAL);
  EXPECT_NE(said.find("input_rate: 50[deg/s], as given"), std::string::npos) << said;
  options.columns = "input_rate=-2.5[deg/s],temperature=25[degC]";
  EXPECT_EQ(read_recording(path, options).input_rate_dph[0], -9000);
  // The number of a column stays one, unless its name says that it is another.
  options.columns = "temperature=3[degC]";
  EXPECT_EQ(read_recording(path, options).temperature_degc, (std::vector<double>{7, 8}));
  const auto said_with = [&](const char* columns) {
    ReadOptions wrong;
    wrong.columns = columns;
    return said_of("time_s,rate_dph,x\n0,1,7\n1,2,8\n", wrong);
  };
  EXPECT_NE(said_with("temperature=2[degC]")
                .find("temperature=2[degC] can be column 2 'rate_dph' or that value; give "
                      "temperature=rate_dph[UNIT], or the value with a point: "
                      "temperature=2.0[UNIT]"),
            std::string::npos)
      << said_with("temperature=2[degC]");
  EXPECT_NE(said_with("temperature=5000[degC]").find("temperature is 5000, outside"),
            std::string::npos);
  EXPECT_NE(said_with("rate=50[deg/s],temperature=25[degC]").find("no column '50[deg/s]'"),
            std::string::npos);
  // Those of a model are of its file.
  ReadOptions remembered;
  remembered.model_columns = "rate=rate_dph[deg/h],temperature=x[degC],input_rate=50[deg/s]";
  EXPECT_TRUE(read_recording(path, remembered).input_rate_dph.empty());
}

// As `rostopic echo -p` names the columns.
TEST(ForeignFiles, OfRostopicEcho_AreReadWithAMap) {
  std::string text =
      "%time,field.header.seq,field.header.frame_id,field.angular_velocity.z,field.temperature\n";
  for (int row = 0; row < kRows; ++row) {
    text += format("%lld,%d,imu,%.17g,%.17g\n", 1700000000000000000 + row * 500000000LL, row,
                   true_rate_dph(row) / 206264.80624709636, true_temperature_degc(row));
  }
  ReadOptions options;
  options.columns =
      "time=time[ns],rate=field.angular_velocity.z[rad/s],temperature=field.temperature";
  const Recording recording = read_recording(temporary_file("bag.csv", text), options);
  ASSERT_EQ(recording.rows(), static_cast<std::size_t>(kRows));
  EXPECT_TRUE(recording.power_on_unknown);
  for (int row = 0; row < kRows; ++row) {
    const auto at = static_cast<std::size_t>(row);
    EXPECT_NEAR(recording.time_s[at], 0.5 * row, 1e-6);
    EXPECT_NEAR(recording.rate_dph[at], true_rate_dph(row), 1e-9);
    EXPECT_NEAR(recording.temperature_degc[at], true_temperature_degc(row), 1e-9);
  }
}

TEST(ForeignFiles, AreRefusedWhereTheMapOfColumnsIsWrong) {
  const std::string content = "time_s,temperature_degc,Gyro [rad/s],x [V]\n0,20,1,2\n";
  const auto said = [&](const char* columns) {
    ReadOptions options;
    options.columns = columns;
    return said_of(content, options);
  };
  EXPECT_NE(said("rate=Gyr[deg/s]").find("no column 'Gyr[deg/s]', which --columns names"),
            std::string::npos);
  EXPECT_NE(said("rate=x[V]").find("is in V, which is no unit of rate"), std::string::npos);
  EXPECT_NE(said("speed=Gyro").find("a recording has no 'speed'"), std::string::npos);
  EXPECT_NE(said("rate").find("is no COLUMN=NAME[UNIT]"), std::string::npos);
  EXPECT_NE(said("rate=3,rate=4").find("two columns are given for rate"), std::string::npos);
}

// An empty field behind the names is nothing, unless the first one may be the number of the row.
TEST(ForeignFiles, FieldWithoutName_NothingIfEmptyElseRefused) {
  const std::string header = "time_s,temperature_degc,rate_dph";
  const auto rows_of = [](const std::string& text) {
    return read_recording(temporary_file("fields.csv", text), {}).rows();
  };
  EXPECT_EQ(rows_of(header + "\n0,20,1,\n1,20,2,\n2,20,3,\n"), 3U);
  EXPECT_EQ(rows_of(header + "\n0,20,1,,\n1,20,2,,\n2,20,3,,\n"), 3U);
  EXPECT_NE(said_of(header + "\n0,20,1\n1,20,2,\n2,20,3\n").find(":3: 4 fields"),
            std::string::npos);
  for (const char* surplus : {"5", "-", "NaN"}) {
    EXPECT_NE(said_of(header + "\n0,20,1,\n1,20,2," + surplus + "\n")
                  .find(":3: 4 fields where the header has 3"),
              std::string::npos);
  }
  EXPECT_EQ(rows_of(header + ",note\n0,20,1,,\n2,20,2,,\n3,20,3,,\n"), 3U);
  EXPECT_NE(said_of(header + ",note\n1,0,20,1,\n2,1,20,2,\n3,2,20,3,\n").find("without a name"),
            std::string::npos);
}

TEST(ForeignFiles, HeaderThatComesAgain_RefusedAtItsLine) {
  std::string text = "time_s,temp_degC,rate_dph\n";
  text += "0,20,1\n1,20,2\n" + text + "2,20,3\n3,20,4\n";
  EXPECT_NE(said_of(text).find(":4: time_s is 'time_s', not a finite number"), std::string::npos)
      << said_of(text);
}

TEST(ForeignFiles, NoHeader_FirstRowIsRead) {
  const auto check = [](const std::string& text, const std::string& columns) {
    ReadOptions options;
    options.columns = columns;
    const Recording recording = read_recording(temporary_file("bare.csv", text), options);
    EXPECT_EQ(recording.rate_dph, std::vector<double>({7.25, 10.75, 8.5})) << text;
  };
  check("0;21,5;7,25\n0,5;21,5;10,75\n1;21,5;8,5\n", "time=1[s],temperature=2[degC],rate=3[deg/h]");
  check(
      "2024-03-05 12:00:00,21.5,7.25\n2024-03-05 12:00:01,21.5,10.75\n"
      "2024-03-05 12:00:02,21.5,8.5\n",
      "time=1,temperature=2[degC],rate=3[deg/h]");
}

// A header may be wrong; who says so is believed.
TEST(ForeignFiles, UnitGivenByTheMap_OutranksTheHeader) {
  const std::string path =
      temporary_file("wrong.csv", "time_s,T(\xC2\xB0),Gyro [rad/s]\n0,20,1\n1,20,2\n");
  EXPECT_THROW(read_recording(path, {}), InputError);
  std::string said;
  ReadOptions options = heard_in(said);
  options.columns = "rate=Gyro[deg/s],temperature=2[degC]";
  const Recording recording = read_recording(path, options);
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{3600, 7200}));
  EXPECT_EQ(recording.temperature_degc, (std::vector<double>{20, 20}));
  EXPECT_NE(said.find("column 3 'Gyro [rad/s]' is taken in deg/s, as chosen, not in rad/s"),
            std::string::npos)
      << said;
}

TEST(ForeignFiles, MinusBeforeARatesName_AskedForTheSign) {
  for (const char* name :
       {"-rate_dph", "- Gyro [deg/h]", "\xE2\x88\x92omega [deg/h]", "neg_gyro_dph"}) {
    const std::string text = std::string("time_s,temp_degC,") + name + "\n0,20,1\n1,20,2\n";
    EXPECT_NE(said_of(text).find("'rate=3[-deg/h]' changes it, 'rate=3[deg/h]' does not"),
              std::string::npos)
        << said_of(text);
    for (const double sign : {-1, 1}) {
      ReadOptions options;
      options.columns = sign < 0 ? "rate=3[-deg/h]" : "rate=3[deg/h]";
      EXPECT_EQ(read_recording(temporary_file("minus.csv", text), options).rate_dph,
                (std::vector<double>{sign * 1, sign * 2}))
          << name;
    }
  }
  ReadOptions counts;
  counts.columns = "rate=3[-counts]";
  counts.scale_factor = 3600;
  EXPECT_EQ(
      read_recording(temporary_file("minus.csv", "time_s,temp_degC,raw\n0,20,1\n1,20,2\n"), counts)
          .rate_dph,
      (std::vector<double>{-1, -2}));
}

// A log that stopped while it was written: what is left of a number is a number.
TEST(ForeignFiles, LastLineCutWithinANumber_RefusedUnlessWhole) {
  const std::string text = "time_s,temperature_degc,rate_dph\n0,20,1.25\n1,20,12.75\n2,20,12.34";
  const auto rows_of = [](const std::string& content) {
    ReadOptions options;
    options.skip_bad_rows = true;
    return read_recording(temporary_file("cut.csv", content), options).rows();
  };
  EXPECT_EQ(said_of(text), "no error");
  EXPECT_EQ(rows_of(text), 3U);
  for (std::size_t cut = 1; cut < 5; ++cut) {
    const std::string left = text.substr(0, text.size() - cut);
    EXPECT_NE(said_of(left).find(":4: the file ends within a line"), std::string::npos) << left;
    EXPECT_EQ(rows_of(left), 2U) << left;
    EXPECT_EQ(said_of(left + "\n"), "no error") << left;
    EXPECT_EQ(rows_of(left + "\n"), 3U) << left;
  }
  // Columns that nobody reads may be cut.
  EXPECT_EQ(said_of("time_s,temperature_degc,rate_dph,note\n0,20,1,8.25\n1,20,2,8.2"), "no error");
}

TEST(ForeignFiles, SayInOneLineWhatWasUnderstood) {
  std::string said;
  read_recording(
      temporary_file("said.csv", "Time [ms];Temp;Gyro_X [deg/s]\n0;20,5;1\n500;20,5;2\n"),
      heard_in(said));
  EXPECT_NE(said.find("said.csv: read as time: column 1 'Time [ms]' / 1000; temperature: column 2 "
                      "'Temp' as degC; rate: column 3 'Gyro_X [deg/s]' x 3600; columns separated "
                      "by ';', decimal comma\n"),
            std::string::npos)
      << said;
  said.clear();
  read_recording(temporary_file("said.csv", "time_s,temperature_degc,rate_dph\n0,20,1\n"),
                 heard_in(said));
  EXPECT_EQ(said, "");
}

TEST(ForeignFiles, HaveATemperatureBetweenItsReadings) {
  std::string content = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 100; ++row) {
    content += format("%d,%s,%d\n", row, row % 10 == 0 ? digits(20 + 0.01 * row).c_str() : "", row);
  }
  std::string said;
  const Recording recording = read_recording(temporary_file("sparse.csv", content), heard_in(said));
  ASSERT_EQ(recording.rows(), 100U);
  EXPECT_NEAR(recording.temperature_degc[37], 20.37, 1e-9);
  EXPECT_NEAR(recording.temperature_degc[99], 20.9, 1e-9);  // held behind the last reading
  EXPECT_NE(said.find("temperature_degc: a reading in 10 of 100 samples (1 in 10)"),
            std::string::npos)
      << said;
}

TEST(ForeignFiles, TemperatureLoggedWhenItChanges_IsKnownBetween) {
  std::string content = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 2000; ++row) {
    content +=
        format("%d,%s,%d\n", row, row % 400 == 0 ? digits(20 + row / 800.0).c_str() : "", row % 7);
  }
  const Recording steps = read_recording(temporary_file("steps.csv", content), {});
  EXPECT_EQ(steps.rows(), 2000U);  // it has not changed since the last reading
  EXPECT_NEAR(steps.temperature_degc[200], 20.25, 1e-9);
}

// A table that swings and once jumps, with a record that repeats its readings for 5 s.
TEST(ForeignFiles, HaveAnInputRateBetweenItsReadings) {
  std::string content = "time_s,temperature_degc,rate_dps,input_rate_dps\n";
  const auto turns = [](int row) { return (row < 502 ? 10 : 20) * std::sin(row / 40.0); };
  for (int row = 0; row < 1000; ++row) {
    content += format("%d,20,%s,%s\n", row, digits(turns(row) + 1e-4 * (row * row % 7)).c_str(),
                      digits(turns(row - row % 5)).c_str());
  }
  std::string said;
  const Recording recording = read_recording(temporary_file("held.csv", content), heard_in(said));
  EXPECT_EQ(recording.rows(), 1000U);
  ASSERT_EQ(recording.masks.size(), 1U);
  EXPECT_NE(said.find("input_rate_dph repeats each reading until the next one"), std::string::npos)
      << said;
  EXPECT_NE(said.find("input_rate_dph: fits and comparisons leave out 5 s in which it changed "
                      "between readings, the first at 500 s; record it with every sample"),
            std::string::npos)
      << said;
}

// As a sensor is read every 300 s: often before a start, too, and written once or in each row.
TEST(ForeignFiles, TemperatureEachFewMinutes_NoSampleLost) {
  for (const bool is_repeated : {false, true}) {
    std::string content = "time_s,temperature_degc,rate_dph\n";
    for (int row = 0; row < 9240; ++row) {
      const bool is_read = row % 300 == 0 || (row < 150 && !is_repeated);
      const double read_s = is_repeated ? row - row % 300 : row;
      content +=
          format("%d,%s,%d\n", row,
                 is_read || is_repeated ? digits(20 + 15 * std::sin(read_s / 2000)).c_str() : "",
                 row * row % 101);
    }
    std::string said;
    const Recording recording = read_recording(temporary_file("slow.csv", content), heard_in(said));
    EXPECT_EQ(recording.rows(), 9240U) << said;
    EXPECT_NEAR(recording.temperature_degc[4050], 20 + 15 * std::sin(2.025), 0.1);
    EXPECT_NE(said.find("temperature_degc: a reading in "), std::string::npos) << said;
    EXPECT_EQ(said.find("temperature_degc repeats each reading") != std::string::npos, is_repeated);
  }
}

// A gyro that follows its temperature at once, as a slow sensor shows that: none of the lag is
// left. One of coarse steps that is read in each row shows them one by one, at any row.
TEST(ForeignFiles, TemperatureHeldForAnyTime_KnownBetween) {
  std::mt19937_64 random(3);
  const auto held = [&](int least_s, int most_s, double step_degc) {
    std::string content = "time_s,temperature_degc,rate_dph\n";
    double degc = 0;
    for (int row = 0, next = 0; row < 9000; ++row) {
      if (row == next) {
        degc = step_degc * std::round((20 + 40 * std::sin(row / 1500.0)) / step_degc);
        next += std::uniform_int_distribution<int>(least_s, most_s)(random);
      }
      content += format("%d,%.4f,%d\n", row, degc, row * row % 101);
    }
    std::string said;
    const Recording recording = read_recording(temporary_file("slow.csv", content), heard_in(said));
    EXPECT_EQ(recording.rows(), 9000U) << said;
    double off_degc = 0;
    for (std::size_t row = 0; row + 300 < recording.rows(); ++row) {
      off_degc +=
          recording.temperature_degc[row] - (20 + 40 * std::sin(static_cast<double>(row) / 1500));
    }
    EXPECT_LT(std::fabs(off_degc / 9000), 0.1) << said;
    return said.find("temperature_degc repeats each reading") != std::string::npos;
  };
  for (const int held_s : {10, 20, 45, 60, 61, 90, 300}) {
    EXPECT_TRUE(held(held_s, held_s, 0.0625)) << held_s;
  }
  EXPECT_TRUE(held(20, 90, 0.0625));
  EXPECT_TRUE(held(5, 90, 0.01));
  EXPECT_TRUE(held(2, 30, 0.01));
  for (const int held_s : {10, 30, 90}) EXPECT_TRUE(held(held_s, held_s, 1)) << held_s;
  for (const double step_degc : {1.0, 0.5, 0.1}) EXPECT_FALSE(held(1, 1, step_degc)) << step_degc;
}

// Two readings at a peak may be equal, and a coarse one is no line of exact temperatures.
TEST(ForeignFiles, CoarseTemperatureEachFewMinutes_StepsKept) {
  for (const bool is_repeated : {false, true}) {
    std::string content = "time_s,temperature_degc,rate_dph\n";
    for (int row = 0; row < 14400; ++row) {
      const double read_s = row - row % 300;
      const double degc = std::round(50 - std::fabs(read_s - 7350) / 240);
      content += format("%d,%s,%d\n", row,
                        row % 300 == 0 || is_repeated ? digits(degc).c_str() : "", row * row % 101);
    }
    std::string said;
    const Recording recording = read_recording(temporary_file("slow.csv", content), heard_in(said));
    EXPECT_EQ(recording.rows(), 14400U) << said;
    EXPECT_EQ(said.find("stands still"), std::string::npos) << said;
    EXPECT_EQ(recording.temperature_period_s, 300);
    EXPECT_EQ(recording.temperature_step_degc, 1);
  }
}

// Each means 1234.5, whatever program or country wrote it.
TEST(ForeignFiles, NumbersOfOtherPrograms_Read) {
  const char* const numbers[] = {"1'234.5",
                                 "1\xE2\x80\x99"
                                 "234.5",
                                 "1\xC2\xA0"
                                 "234.5",
                                 "1\xE2\x80\xAF"
                                 "234.5",
                                 "1.2345D+03",
                                 "+1.2345d3"};
  for (const char* const number : numbers) {
    const std::string text =
        "time_s;temperature_degc;rate_dph\n0D0;20;" + std::string(number) + "\n";
    EXPECT_EQ(said_of(text), "no error") << number;
    EXPECT_EQ(read_recording(temporary_file("number.csv", text), {}).rate_dph,
              std::vector<double>{1234.5})
        << number;
  }
  ReadOptions options;
  options.scale_factor = 3600;
  const std::string hexadecimal = "time_s,temperature_degc,counts\n0,20,0x4D2\n1,20,0X4d2\n";
  EXPECT_EQ(read_recording(temporary_file("number.csv", hexadecimal), options).rate_dph,
            (std::vector<double>{1234, 1234}));
  for (const char* const number :
       {"1'23.5", "12'34", "'234", "0x", "0x4G", "1D", "D1", "1D2D3", "1e2D3", "5 days"}) {
    const std::string text =
        "time_s;temperature_degc;rate_dph\n0;20;1\n1;20;" + std::string(number) + "\n";
    EXPECT_NE(said_of(text).find("not a finite number"), std::string::npos) << number;
  }
}

// A step a time, as evenly as the ramp goes, and none in a soak.
TEST(ForeignFiles, CoarseTemperatureInARamp_IsNoSlowSensor) {
  std::string content = "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 9001; ++row) {
    content += format("%d,%d,%d\n", row, std::min(row / 180, 30), row * row % 101);
  }
  std::string said;
  const Recording recording = read_recording(temporary_file("coarse.csv", content), heard_in(said));
  EXPECT_EQ(recording.rows(), 9001U) << said;
  EXPECT_EQ(said.find("repeats each reading"), std::string::npos) << said;
}

// Lines of terminals and of spreadsheets for a page; LabVIEW's last name has no field.
TEST(ForeignFiles, FurtherLayouts_Read) {
  const char* const files[] = {
      "time_s,temperature_degc,rate_dph\r\r\n0,20,1\r\r\n1,20.5,2\r\r\n",
      "time_s|temp_degC|rate_dph\n0|20|1\n1|20.5|2\n",
      "time_s\ttemp_degC\trate_dph\tComment\n0\t20\t1\n1\t20.5\t2\n",
      "time;temp_degC;rate_dph\n2024-03-05 12:30:15:250;20;1\n2024-03-05 12:30:16:250;20.5;2\n"};
  for (const char* const content : files) {
    std::string said;
    const Recording recording =
        read_recording(temporary_file("layout.csv", content), heard_in(said));
    EXPECT_EQ(recording.time_s, (std::vector<double>{0, 1})) << content;
    EXPECT_EQ(recording.rate_dph, (std::vector<double>{1, 2})) << content;
  }
}

TEST(ForeignFiles, LeaveOutRowsWhoseValuesNobodyKnows) {
  std::string said;
  const Recording recording =
      read_recording(temporary_file("holes.csv",
                                    "time_s,temperature_degc,rate_dph,supply_v\n"
                                    "0,,1,5\n1,20,NaN,5\n2,20,3,\n3,20,4,\n,20,5,\n200,,6,\n"
                                    "400,21,7,\n401,21,8,\n"),
                     heard_in(said));
  EXPECT_EQ(recording.time_s, (std::vector<double>{2, 3, 400, 401}));
  EXPECT_EQ(recording.temperature_period_s, 0) << "a reading in each row but those";
  EXPECT_EQ(recording.rate_dph, (std::vector<double>{3, 4, 7, 8}));
  EXPECT_EQ(recording.empty_rows, 3U);
  EXPECT_TRUE(recording[fog::Input::supply].empty());
  EXPECT_NE(said.find("1 sample left out: no time or rate, the first at line 6"), std::string::npos)
      << said;
  EXPECT_NE(said.find("2 samples left out: no temperature or input rate within 60 s, the first at "
                      "line 2"),
            std::string::npos)
      << said;
}

// A file with any fault is read or refused; every column that is read is complete.
TEST(ForeignFiles, DamagedAreReadWholeOrRefused) {
  const std::vector<Property> all = properties();
  std::mt19937 random(1);
  const std::string alphabet = "0123456789.,;-+eE\n\r\t #%[]()\"naifTZ:/\xC2\xB0\xB5";
  std::size_t read = 0;
  for (int round = 0; round < 3000; ++round) {
    FileWriter file;
    for (int i = 0; i < 3; ++i) all[random() % all.size()].apply(file);
    std::string content = file.content();
    for (unsigned change = random() % 4; change > 0 && !content.empty(); --change) {
      const std::size_t at = random() % content.size();
      if (random() % 2 == 0) {
        content[at] = alphabet[random() % alphabet.size()];
      } else {
        content.erase(at, 1 + random() % 20);
      }
    }
    ReadOptions options;
    options.skip_bad_rows = random() % 2 == 0;
    try {
      const Recording recording = read_recording(temporary_file("damaged.csv", content), options);
      ++read;
      for (const ColumnInfo& info : kColumns) {
        const std::vector<double>& column = recording[info.column];
        EXPECT_TRUE(column.empty() || column.size() == recording.rows());
        for (const double value : column) EXPECT_TRUE(std::isfinite(value));
      }
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(read, 1000U);
}

TEST(ForeignFiles, AreToldFromAStreamByTheirText) {
  // The first bytes of a capture may look like a byte order mark.
  EXPECT_NE(said_of(std::string("\xFF\xFE\xA5\x5A\x01\x02\x80\x90", 8) + std::string(600, '\x07'))
                .find("neither text nor a sensor stream"),
            std::string::npos);
}

}  // namespace
}  // namespace fogcomp::recording
