// The lines of a board: as options name them, on a serial device, and what fits on them.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdint>
#include <string>

#include "board/board_port.hpp"
#include "board/board_table.hpp"
#include "board/board_texts.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"

// Linux' own settings of a terminal, which know bit rates without a name (asm/termbits.h, whose
// other names are those of termios.h). TCGETS2 wants it by this name.
struct termios2 {
  std::uint32_t c_iflag, c_oflag, c_cflag, c_lflag;
  std::uint8_t c_line, c_cc[19];
  std::uint32_t c_ispeed, c_ospeed;
};

namespace {

using fog::SerialLine;
using fogcomp::InputError;
using fogcomp::board::line_text;
using fogcomp::board::parse_line;

SerialLine parse(const std::string& text) {
  return parse_line(text, fog::kMaxOutputBaud, "--output-line");
}

TEST(LineText, EveryFormat_ThereAndBack_Same) {
  for (const char* text :
       {"9600", "115200,8N2", "230400,8E1", "614400,8E2", "921600,8O1", "4147200,8O2"}) {
    EXPECT_EQ(line_text(parse(text)), text);
  }
  EXPECT_EQ(line_text(parse("921600,8N1")), "921600");
  EXPECT_EQ(parse("921600").word(), SerialLine().word());
}

TEST(LineText, WhatIsNoLine_RefusedWithItsName) {
  for (const char* text : {"", "fast", "9599", "4147201", "115200.5", "115200,", "115200,7E1",
                           "115200,8e1", "115200,8N1,", "8E1", "-9600", "nan"}) {
    try {
      parse(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("--output-line"), std::string::npos) << text;
    }
  }
  EXPECT_THROW(parse_line("4147200", fog::kMaxSensorBaud, "--sensor-line"), InputError);
}

struct Settings {
  std::uint32_t baud;
  bool two_stop_bits;
};

Settings settings_of(int terminal) {
  termios2 settings{};
  EXPECT_EQ(ioctl(terminal, TCGETS2, &settings), 0);
  return {settings.c_ospeed, (settings.c_cflag & CSTOPB) != 0};
}

// A pseudo-terminal has all but parity, which its driver drops.
TEST(BoardPort, Line_OfASerialDevice_IsSet) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  fogcomp::board::BoardPort port(ptsname(master), parse("4147200,8O2"));
  EXPECT_EQ(settings_of(master).baud, 4147200U);
  EXPECT_TRUE(settings_of(master).two_stop_bits);
  port.set_line(parse("9600"));
  EXPECT_EQ(settings_of(master).baud, 9600U);
  EXPECT_FALSE(settings_of(master).two_stop_bits);
  close(master);
}

std::string refusal(const fogcomp::board::BoardSettings& settings,
                    const fogcomp::model::Model& model = fog::test::paper_like_model()) {
  try {
    fogcomp::board::make_board_table(model, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BoardTable, FramesThatDoNotFit_RefusedWithTheSum) {
  fogcomp::board::BoardSettings settings;
  settings.sample_rate_hz = 5000;
  settings.output = fog::OutputSelection::both;
  EXPECT_NE(refusal(settings).find("64 bytes of 10 bits, which take 695 us at 921600 Bd, and a "
                                   "sample period is 200 us"),
            std::string::npos)
      << refusal(settings);
  settings.output_line = parse("4147200");
  EXPECT_EQ(refusal(settings), "");
  settings.sensor_line = parse("921600,8E2");
  EXPECT_NE(refusal(settings).find("16 bytes of 12 bits, which take 209 us at 921600 Bd"),
            std::string::npos)
      << refusal(settings);
}

// At 5000 Hz half a sample period is 14,000 instructions.
TEST(BoardTable, DearModel_HighRateRefusedWithTheSum) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  fogcomp::board::BoardSettings settings;
  settings.output_line = parse("4147200");
  settings.sample_rate_hz = 5000;
  EXPECT_EQ(refusal(settings, model), "");
  model.terms.push_back(fog::test::written_term("x = sin(T/3)*sin(T/4)*sin(T/5)*sin(T/6)*exp(-t)"));
  model.terms.push_back(fog::test::written_term("y = cos(T/3)*cos(T/4)*cos(T/5)*cos(T/6)*exp(-t)"));
  const std::string said = refusal(settings, model);
  EXPECT_NE(said.find("5000 Hz is too fast: a sample may take "), std::string::npos) << said;
  EXPECT_NE(said.find("half a sample period of 200 us has time for 14000"), std::string::npos)
      << said;
  const std::size_t at = said.find("at most ");
  ASSERT_NE(at, std::string::npos) << said;
  settings.sample_rate_hz = std::stod(said.substr(at + 8));
  EXPECT_GT(settings.sample_rate_hz, 1000);
  EXPECT_EQ(refusal(settings, model), "") << "what the refusal proposes";
  settings.sample_rate_hz += 20;  // more than a us
  EXPECT_NE(refusal(settings, model), "");
}

}  // namespace
