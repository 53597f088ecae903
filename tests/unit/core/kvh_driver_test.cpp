// A board as seen by drivers of KVH gyros: they search for the header, check CRC or sequence, and
// sum delta angles; at start-up they send commands.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "board/host_compensator.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/delta_angle.hpp"
#include "core/frames/kvh_bit.hpp"
#include "core/frames/kvh_command.hpp"
#include "support/sample_models.hpp"

namespace fog {
namespace {

float as_float(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(DeltaAngle, HasItsUnitFromPi) {
  const long double exact = std::ldexp(3.14159265358979323846264338L, 80) / 648000e6L / 1024;
  EXPECT_EQ(DeltaAngle::kAnglePerLsbUs, static_cast<std::uint64_t>(std::llround(exact)));
}

// The integral is exact in 128 bits; so is the sum of the floats, whose LSBs are 2^-48 rad or more.
__extension__ typedef __int128 Wide;

TEST(DeltaAngle, SumsToTheIntegralOfTheRateToHalfAnLsbOfTheLast) {
  std::mt19937 random(1);
  for (const std::uint32_t period_us : {5000U, 1U, 1000U, 999999U}) {
    DeltaAngle angle(period_us);
    Wide integral = 0;  // 2^-80 rad
    Wide sum = 0;
    long double integral_rad = 0;
    for (int i = 0; i < 1000000; ++i) {
      // Noise at rest, a rotation back and forth, then any rate.
      std::int32_t raw = static_cast<std::int32_t>(random() % 3001U) - 1000;
      if (i > 300000) raw += static_cast<std::int32_t>(4e8 * std::sin(i / 5000.0));
      if (i > 600000) raw = static_cast<std::int32_t>(static_cast<std::uint32_t>(random()));
      if (i > 999000) raw = INT32_MIN;
      angle.step(Rate::from_raw(raw));
      integral += Wide{raw} * period_us * DeltaAngle::kAnglePerLsbUs;
      integral_rad += raw / 1024.0L * period_us * 1e-6L * 3.14159265358979323846264338L / 648000;
      const float sent = as_float(angle.bits());
      sum += Wide{static_cast<std::int64_t>(std::ldexp(sent, 48))} * (Wide{1} << 32);
      const float lsb = std::nextafter(std::abs(sent), HUGE_VALF) - std::abs(sent);
      const double left = std::ldexp(static_cast<double>(integral - sum), -80);
      ASSERT_LE(std::abs(left), 0.5 * static_cast<double>(lsb) + 0x1p-48) << i;
    }
    EXPECT_NEAR(std::ldexp(static_cast<double>(sum), -80) / static_cast<double>(integral_rad), 1,
                1e-10);
  }
}

TEST(DeltaAngle, IsNoneWhereTimeStands) {
  DeltaAngle angle(5000);
  angle.step(Rate::from_raw(1000));
  EXPECT_GT(as_float(angle.bits()), 0);
  angle.stand();
  EXPECT_EQ(as_float(angle.bits()), 0);
}

// An image whose header asks for no angles.
TEST(Rotation, WithoutAngles_IsTheRate) {
  Rotation<false> rotation{ModelParameters()};
  rotation.step(Rate::from_raw(1000));
  rotation.stand();
  EXPECT_EQ(rotation.bits(Rate::from_raw(77)), rate_as_radians_float(Rate::from_raw(77)));
}

// As drivers that check the CRC do: bytes are dropped until the header is in front.
struct CheckingDriver {
  void take(const std::vector<std::uint8_t>& bytes) {
    for (const std::uint8_t byte : bytes) {
      buffer.push_back(byte);
      while (!buffer.empty() && buffer[0] != 0xFE) buffer.erase(buffer.begin());
      if (buffer.size() < 36) continue;
      const bool header = buffer[1] == 0x81 && buffer[2] == 0xFF && buffer[3] == 0x55;
      if (header && word(32) == crc32(buffer.data(), 32, kCrc32Initial)) {
        read();
      } else {
        ++bad;
      }
      buffer.clear();
    }
  }
  std::uint32_t word(std::size_t at) const {
    return (std::uint32_t{buffer[at]} << 24U) | (std::uint32_t{buffer[at + 1]} << 16U) |
           (std::uint32_t{buffer[at + 2]} << 8U) | buffer[at + 3];
  }
  void read() {
    if (frames > 0 && buffer[29] != (sequence + 1) % 128) ++out_of_sequence;
    sequence = buffer[29];
    ++frames;
    sent_rad += static_cast<double>(as_float(word(12)));
    if (buffer[28] == 0x77) ++of_six_axes;
    if ((buffer[28] & 4U) == 0) return;
    ++valid;
    angle_rad += static_cast<double>(as_float(word(12)));
  }
  std::vector<std::uint8_t> buffer;
  int sequence = 0;
  int frames = 0;
  int bad = 0;
  int out_of_sequence = 0;
  int valid = 0;
  int of_six_axes = 0;
  double angle_rad = 0;
  double sent_rad = 0;  // of frames that are not valid, too
};

TEST(KvhDriver, TakesAllFramesOfABoardThatSendsAngles) {
  fogcomp::model::Model model = test::paper_like_model();
  model.terms.clear();
  model.network = {};
  model.denoise.levels = 0;
  fogcomp::board::BoardSettings settings = test::lenient_board();
  settings.output_options = kRotationIsAngle;
  const auto table = fogcomp::board::make_board_table(model, settings);
  const auto parameters = fogcomp::board::read_board_table(table, "test");
  fogcomp::board::HostCompensator board(parameters, IntegrityToken::not_needed());
  CheckingDriver driver;
  double turned_rad = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    const auto rate_raw = static_cast<std::int32_t>((36000 + i % 7) * 1024);  // 10 deg/s
    const auto frame = encode_sensor_frame(
        {static_cast<std::uint16_t>(i), rate_raw, 25 * 65536 + i % 5, true, true});
    for (const std::uint8_t byte : frame) {
      std::vector<std::uint8_t> out(kMaxOutputBytes);
      out.resize(board.feed(byte, out.data()));
      driver.take(out);
    }
    if (board.last().denoised_valid()) turned_rad += rate_raw / 1024.0 * 0.005 * M_PI / 648000;
  }
  EXPECT_EQ(driver.frames, kSamples);
  EXPECT_EQ(driver.bad, 0);
  EXPECT_EQ(driver.out_of_sequence, 0);
  EXPECT_GT(driver.valid, kSamples - 300);
  EXPECT_EQ(driver.of_six_axes, 0) << "a driver that asks for all six axes takes none";
  EXPECT_NEAR(driver.angle_rad, turned_rad, 1e-9 * turned_rad + 1e-10);
}

// Lost samples add no angle. Of a turn that the outlier gate leaves out the undelayed angles have
// all, the denoised ones what stands in for it.
TEST(KvhDriver, AnglesThroughLossesAndGatedTurn_SumToMeasured) {
  fogcomp::model::Model model = test::paper_like_model();
  model.terms.clear();
  model.network = {};
  const auto delay = static_cast<int>(denoise_delay(16, 5));
  for (const OutputOptions undelayed : {OutputOptions{0}, kRotationIsUndelayed}) {
    fogcomp::board::BoardSettings settings = test::lenient_board();
    settings.output_options = static_cast<OutputOptions>(kRotationIsAngle | undelayed);
    const auto table = fogcomp::board::make_board_table(model, settings);
    const auto parameters = fogcomp::board::read_board_table(table, "test");
    fogcomp::board::HostCompensator board(parameters, IntegrityToken::not_needed());
    CheckingDriver driver;
    constexpr std::int32_t kRate = 36'000 * 1024;  // 10 deg/s
    constexpr double kRadPerCount = 0.005 * M_PI / 648000 / 1024;
    std::int64_t measured = 0;
    constexpr int kSamples = 6000;
    int turned_while_valid = 0;
    std::uint16_t number = 0;
    for (int i = 0; i < kSamples; ++i) {
      if (i == 1500 || i == 1501 || i == 4000) number = static_cast<std::uint16_t>(number + i / 9);
      const bool turns = i == 3000 || i == 3777;
      const std::int32_t rate = kRate + i % 7 * 1024;  // or the gyro would stand still
      const std::int32_t counts = turns ? 2 * kRate : rate;
      const auto frame = encode_sensor_frame({number++, counts, 25 * 65536 + i % 5, true, true});
      const int valid_before = driver.valid;
      for (const std::uint8_t byte : frame) {
        std::vector<std::uint8_t> out(kMaxOutputBytes);
        out.resize(board.feed(byte, out.data()));
        driver.take(out);
      }
      constexpr int kAgreed = 100;  // half a second of readings have to agree
      const bool is_out = undelayed != 0 || (i >= kAgreed && i < kSamples - delay);
      if (undelayed == 0 && i == kAgreed) measured += std::int64_t{rate} * delay;  // as if for ever
      if (is_out) measured += undelayed != 0 ? counts : rate;
      const int sent_for = undelayed != 0 ? i : i - delay;
      if (sent_for == 3000 || sent_for == 3777) turned_while_valid += driver.valid - valid_before;
    }
    EXPECT_EQ(driver.frames, kSamples);
    EXPECT_EQ(driver.out_of_sequence, 3) << "by which a driver sees the losses";
    EXPECT_EQ(turned_while_valid, undelayed != 0 ? 2 : 0);
    const double measured_rad = static_cast<double>(measured) * kRadPerCount;
    const double cut_off = undelayed != 0 ? 1e-9 : 1e-6;  // what the denoiser has of the last
    EXPECT_NEAR(driver.sent_rad, measured_rad, cut_off * measured_rad) << int{undelayed};
  }
}

struct Terminal {
  explicit Terminal(KvhSettings settings) : commands(settings) {}
  std::string send(const std::string& text) {
    std::string answers;
    for (const char character : text) {
      std::uint8_t out[KvhCommands::kMaxAnswer];
      const std::size_t size = commands.feed(static_cast<std::uint8_t>(character), out, status);
      answers.append(reinterpret_cast<const char*>(out), size);
    }
    return answers;
  }
  KvhCommands commands;
  Status status = Status::none;
};

TEST(KvhCommands, AnswerWhatDriversSendAtStartUp) {
  Terminal user({200, true});
  EXPECT_EQ(user.send("=CONFIG,0\n"), "");
  EXPECT_EQ(user.send("?TEMPUNITS\n"), "") << "outside the configuration mode";
  EXPECT_EQ(user.send("=CONFIG,1\n"), "CONFIG,1\r\n");
  EXPECT_TRUE(user.commands.configuring());
  EXPECT_EQ(user.send("?TEMPUNITS\n"), "TEMPUNITS,C\r\n");
  EXPECT_EQ(user.send("?ROTFMT\n"), "ROTFMT,DELTA\r\n");
  EXPECT_EQ(user.send("?DR\n"), "DR,200\r\n");
  EXPECT_EQ(user.send("=ROTFMT,DELTA\r\n"), "ROTFMT,DELTA\r\n");
  EXPECT_EQ(user.send("=ROTFMT,RATE\r\n"), "INVALID,=ROTFMT,RATE\r\n");
  EXPECT_EQ(user.send("=ROTUNITS,RAD\r\n"), "ROTUNITS,RAD\r\n");
  EXPECT_EQ(user.send("=DR,100\n"), "INVALID,=DR,100\r\n");
  EXPECT_EQ(user.send("?DRX\n?D\n=DR\n=DR,\n=DR,2\n=DR,2000\n"),
            "INVALID,?DRX\r\nINVALID,?D\r\nINVALID,=DR\r\nINVALID,=DR,\r\nINVALID,=DR,2\r\n"
            "INVALID,=DR,2000\r\n");
  EXPECT_EQ(user.send("=CONFIG,0\n"), "");
  EXPECT_FALSE(user.commands.configuring());
}

// What a receiver sends that wants another line and gives the time of a sample.
TEST(KvhCommands, LineAndSynchronisation_ToldAndNotChanged) {
  Terminal user({200, true, 460'800});
  user.send("=CONFIG,1\n");
  EXPECT_EQ(user.send("?baud\n?MSYNC\n"), "BAUD,460800\r\nMSYNC,IMU\r\n");
  EXPECT_EQ(user.send("=BAUD,460800\n=MSYNC,IMU\n"), "BAUD,460800\r\nMSYNC,IMU\r\n");
  EXPECT_EQ(user.send("=BAUD,46080\n=BAUD,921600\n=MSYNC,EXT\n"),
            "INVALID,=BAUD,46080\r\nINVALID,=BAUD,921600\r\nINVALID,=MSYNC,EXT\r\n");
}

std::string message(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

// As KVH's manual has it of a gyro without a fault.
TEST(KvhBit, NoFault_MessageOfTheManual) {
  Terminal user({200, false});
  const std::string good = message({0xFE, 0x81, 0, 0xAA, 127, 127, 127, 127, 127, 127, 0x23});
  EXPECT_EQ(user.send("?BIT\r\n"), good) << "outside the configuration mode";
  EXPECT_EQ(user.send("?bit,2\n"),
            message({0xFE, 0x81, 0, 0xAB, 127, 127, 127, 127, 127, 127, 127, 127, 0x22}));
  user.send("=CONFIG,1\n");
  EXPECT_EQ(user.send("?bit\n"), good);
  EXPECT_EQ(user.send("?BIT,3\n=BIT\n?BITS\n"),
            "INVALID,?BIT,3\r\nINVALID,=BIT\r\nINVALID,?BITS\r\n");
}

TEST(KvhBit, EachFlag_ClearsItsTest) {
  const struct {
    Status flag;
    int test;  // -1: none
  } flags[] = {{Status::gyro_invalid, 11},     {Status::rate_out_of_range, 11},
               {Status::gyro_stuck, 11},       {Status::rate_jump, 11},
               {Status::model_refused, 12},    {Status::temperature_invalid, 21},
               {Status::self_test_failed, 42}, {Status::sequence_gap, 44},
               {Status::sample_rate, 44},      {Status::no_samples, 44},
               {Status::thermal_settling, -1}, {Status::drift_held, -1},
               {Status::denoised_refused, -1}};
  for (const auto& each : flags) {
    Terminal user({200, false});
    user.status = each.flag;
    const std::string said = user.send("?BIT,2\n");
    ASSERT_EQ(said.size(), kKvhExtendedBitBytes);
    int sum = 0;
    for (std::size_t i = 0; i < kKvhExtendedBitBytes - 1; ++i) {
      const auto byte = static_cast<std::uint8_t>(said[i]);
      sum += byte;
      const int in_byte = each.test - 8 * (static_cast<int>(i) - 4);
      const int failed = in_byte >= 0 && in_byte < 8 ? 1 << in_byte : 0;
      if (i < 4) continue;
      EXPECT_EQ(byte, 0x7F - failed) << each.test << " " << i;
    }
    EXPECT_EQ(static_cast<std::uint8_t>(said.back()), sum % 256);
  }
}

// Lower case, all at once, and with whatever was in the buffer behind the line's end.
TEST(KvhCommands, AreFoundAmongOtherBytes) {
  Terminal user({100, false});
  EXPECT_EQ(user.send(std::string("=config,1\n=dr,100\n\0\x7F\xFE\0\0\0=config,0\n", 34)),
            "CONFIG,1\r\nDR,100\r\n");
  EXPECT_FALSE(user.commands.configuring());
  EXPECT_EQ(user.send(std::string("\xA5\x99\0\0\x34\x2A=CON=CONFIG,1\n", 20)), "CONFIG,1\r\n");
  EXPECT_EQ(user.send("=" + std::string(1000, 'A') + "\n?ROTFMT\r"), "ROTFMT,RATE\r\n");
  std::mt19937 random(1);
  for (int i = 0; i < 1000000; ++i) user.send({static_cast<char>(random() % 128U)});
}

}  // namespace
}  // namespace fog
