#include "simulation/programme.hpp"

#include <gtest/gtest.h>

#include "simulation/chamber.hpp"
#include "simulation/embedded_files.hpp"
#include "support/input_error.hpp"

namespace fogcomp::simulation {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_profile(text, "test.profile", 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Profile, MakesLegsOfSoaksRampsAndSteps) {
  const Programme programme = parse_profile(
      "start 10 degC\n"
      "segment rest   # a comment\n"
      "soak 2h\n"
      "segment cold\n"
      "ramp to -20 C at 0.5 K/min\n"
      "step to 40 degC\n"
      "soak 30 s\n",
      "test", 1);
  EXPECT_EQ(programme.start_degc, 10);
  ASSERT_EQ(programme.legs.size(), 3U);
  EXPECT_EQ(programme.legs[0].end_s, 7200);
  EXPECT_EQ(programme.legs[0].segment, "rest");
  EXPECT_EQ(programme.legs[1].end_s, 7200 + 3600);
  EXPECT_EQ(programme.legs[1].to_degc, -20);
  EXPECT_EQ(programme.legs[2].from_degc, 40);
  EXPECT_EQ(programme.duration_s(), 10830);
}

TEST(Profile, RepeatsNestedBlocks) {
  const Programme programme = parse_profile(
      "repeat 3\n soak 1 min\n repeat 2\n heater 2 W\n soak 1 s\n end\n heater 0 W\nend\n", "test",
      1);
  EXPECT_EQ(programme.legs.size(), 9U);
  EXPECT_EQ(programme.duration_s(), 3 * (60 + 2));
  EXPECT_EQ(programme.legs[1].conditions.heater_w, 2);
  EXPECT_EQ(programme.legs[3].conditions.heater_w, 0);
}

TEST(Profile, KeepsRandomStepsWithinBoundsAndTiedToTheSeed) {
  const std::string text = "random_steps 10 degC to 30 degC at 3 degC/min every 15 min for 10 h\n";
  const Programme first = parse_profile(text, "test", 1);
  const Programme again = parse_profile(text, "test", 1);
  const Programme other = parse_profile(text, "test", 2);
  EXPECT_EQ(first.duration_s(), 36000);
  EXPECT_EQ(first.legs.size(), again.legs.size());
  EXPECT_EQ(first.legs[0].to_degc, again.legs[0].to_degc);
  EXPECT_NE(first.legs[0].to_degc, other.legs[0].to_degc);
  for (const Leg& leg : first.legs) {
    EXPECT_GE(leg.to_degc, 10);
    EXPECT_LE(leg.to_degc, 30);
  }
}

// Any nesting, of any depth, ends soon and with a message.
TEST(Profile, BoundsNestingAndPasses) {
  const auto nested = [](std::size_t depth, const std::string& repeat, const std::string& inside) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += repeat + "\n";
    text += inside;
    for (std::size_t i = 0; i < depth; ++i) text += "end\n";
    return text;
  };
  EXPECT_EQ(error_of(nested(20, "repeat 1", "soak 1 s\n")), "no error");
  EXPECT_EQ(error_of(nested(100'000, "repeat 1", "soak 1 s\n")),
            "test.profile:21: 'repeat' within 20 others; nest fewer");
  EXPECT_NE(error_of(nested(20, "repeat 100000", "")).find("more than a million statements"),
            std::string::npos);
}

TEST(Profile, NamesFileAndLineOfWhatItCannotRead) {
  EXPECT_EQ(error_of("soak 1 h\nsaok 2 h\n"),
            "test.profile:2: unknown statement 'saok' (did you mean 'soak'?); fogcomp simulate "
            "--list shows the statements");
  EXPECT_EQ(error_of("soak\n"),
            "test.profile:1: the line ends where a quantity such as '2 h' is expected");
  EXPECT_EQ(error_of("soak two h\n"), "test.profile:1: 'two' is not a quantity such as '2 h'");
  EXPECT_EQ(error_of("soak 2\n"), "test.profile:1: the line ends where the unit of 2 is expected");
  EXPECT_EQ(error_of("soak 2 K\n"), "test.profile:1: unit 'K' is not one of s, min, h");
  EXPECT_EQ(error_of("soak -2 h\n"), "test.profile:1: -2 h is outside 0.001 s to 10000 h");
  EXPECT_EQ(error_of("soak nan h\n"), "test.profile:1: 'nan' is not a quantity such as '2 h'");
  EXPECT_EQ(error_of("soak 1 h 2\n"), "test.profile:1: '2' is too much; one statement a line");
  EXPECT_EQ(error_of("\n\nramp 20 degC\n"), "test.profile:3: '20' where 'to' is expected");
  EXPECT_EQ(error_of("axis upp\nsoak 1 h\n"),
            "test.profile:1: 'upp' is not one of up, down, north, south, east, west (did you mean "
            "'up'?)");
  EXPECT_EQ(error_of("step to 500 degC\n"), "test.profile:1: 500 degC is outside -100 to 150 degC");
}

TEST(Profile, RefusesProgrammesThatMakeNoSense) {
  EXPECT_EQ(error_of(""), "test.profile: the programme takes no time; add a soak or a ramp");
  EXPECT_EQ(error_of("soak 1 h\nstart 20 degC\n"),
            "test.profile:2: 'start' must be the first statement");
  EXPECT_EQ(error_of("repeat 2\nsoak 1 h\n"), "test.profile:1: 'repeat' without an 'end' below it");
  EXPECT_EQ(error_of("soak 1 h\nend\n"), "test.profile:2: 'end' without a 'repeat' above it");
  EXPECT_EQ(error_of("repeat 0\nsoak 1 h\nend\n"),
            "test.profile:1: '0' is not a whole number from 1 to 100000");
  EXPECT_EQ(error_of("power off\nsoak 1 h\n"),
            "test.profile:2: the programme must begin with the power on: time counts from there");
  EXPECT_EQ(error_of("repeat 20000\nsoak 1 h\nend\n"),
            "test.profile:2: the programme gets longer than 10000 h; make it shorter");
  EXPECT_EQ(error_of("repeat 10000\nrepeat 10000\nheater 1 W\nend\nend\nsoak 1 h\n"),
            "test.profile:3: the programme has more than a million statements; repeat less often");
}

TEST(Profile, SweepsTheTableUntilTheNextRate) {
  const Programme programme = parse_profile(
      "rate 3 deg/s\nsoak 1 min\nsweep 50 deg/s every 40 s\nsoak 2 min\nrate 0 deg/s\nsoak 1 "
      "min\n",
      "test", 1);
  ASSERT_TRUE(programme.sets_rate);
  EXPECT_EQ(table_rate_dph(programme.legs[0].conditions, 30), 3 * 3600);
  EXPECT_NEAR(table_rate_dph(programme.legs[1].conditions, 60), 0, 1e-9);
  EXPECT_NEAR(table_rate_dph(programme.legs[1].conditions, 70), 50 * 3600, 1e-6);
  EXPECT_NEAR(table_rate_dph(programme.legs[1].conditions, 90), -50 * 3600, 1e-6);
  EXPECT_EQ(table_rate_dph(programme.legs[2].conditions, 190), 0);
  EXPECT_NE(error_of("sweep 50 deg/s every 2 s\nsoak 1 h\n").find("10 s or more"),
            std::string::npos);
  EXPECT_NE(error_of("sweep 50 deg/s\nsoak 1 h\n"), "no error");
}

TEST(Profile, OfEveryReadyMadeNameCanBeRead) {
  EXPECT_GE(ready_made_profiles().size(), 7U);
  for (const EmbeddedFile& file : ready_made_profiles()) {
    EXPECT_GT(parse_profile(file.text, file.name, 1).duration_s(), 3600) << file.name;
    EXPECT_FALSE(first_sentence(file).empty()) << file.name;
  }
}

TEST(Profile, PaperLastsAsLongAsThePapersSamples) {
  const std::string text = find_text("paper", ready_made_profiles(), "profile");
  EXPECT_EQ(parse_profile(text, "paper", 1).duration_s(), 59550);
}

TEST(Profile, NotFoundSuggestsTheNearestName) {
  try {
    find_text("papr", ready_made_profiles(), "profile");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'paper'?"), std::string::npos);
  }
}

TEST(Chamber, FollowsARampWithALagAndAStepAtItsOwnSpeed) {
  const Programme programme =
      parse_profile("ramp to 50 degC at 1 degC/min\nstep to -30 degC\nsoak 1 h\n", "test", 1);
  Chamber chamber(programme, 1, 1);
  for (int i = 0; i < 1800; ++i) chamber.step();
  EXPECT_NEAR(chamber.state().air_degc, 50 - 2, 0.3);  // 2 min behind
  double before_degc = chamber.state().air_degc;
  for (int i = 0; i < 300; ++i) chamber.step();
  EXPECT_NEAR(before_degc - chamber.state().air_degc, 25, 0.5);  // 5 K/min at most
  for (int i = 0; i < 3300; ++i) chamber.step();
  EXPECT_NEAR(chamber.state().air_degc, -30, 0.3);
  EXPECT_EQ(chamber.state().time_s, 5400);
}

}  // namespace
}  // namespace fogcomp::simulation
