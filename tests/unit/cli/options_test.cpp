// The options of all commands: one declaration each, used by its own command only.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "cli/command.hpp"
#include "cli/fit_options.hpp"
#include "support/input_error.hpp"

namespace fogcomp::cli {
namespace {

std::string refusal(Command& command, const std::vector<std::string>& words) {
  try {
    parse(command, words);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// A command's options are its members: declaring one registers it, and a mistyped name does not
// compile. This test covers the rest.
TEST(Options, AreListedOnceByEveryCommand) {
  for (const CommandPointer& command : all_commands()) {
    std::set<std::string> names;
    for (const Option* option : command->options()) {
      EXPECT_TRUE(names.insert(option->name).second) << command->name() << " " << option->name;
      EXPECT_EQ(command->find_option(option->name), option);
      EXPECT_FALSE(option->help.empty()) << command->name() << " " << option->name;
    }
  }
}

TEST(Options, ThatACommandNeedsAreItsOwn) {
  for (const CommandPointer& command : all_commands()) {
    const auto lists = [&](const Option* wanted) {
      const auto& options = command->options();
      return std::find(options.begin(), options.end(), wanted) != options.end();
    };
    for (const Command::Need& need : command->needs) {
      EXPECT_TRUE(lists(need.option)) << command->name();
      for (const Option* other : need.unless) EXPECT_TRUE(lists(other)) << command->name();
    }
    for (const Option* other : command->stand_for_positional)
      EXPECT_TRUE(lists(other)) << command->name();
    EXPECT_TRUE(command->further_models == nullptr || lists(command->further_models))
        << command->name();
  }
}

TEST(Options, HaveDefaultsThatTheyWouldTake) {
  for (const CommandPointer& command : all_commands()) {
    for (const Option* option : command->options()) {
      const auto* number = dynamic_cast<const Number*>(option);
      if (option->default_value.empty()) continue;
      if (number != nullptr) {
        EXPECT_NO_THROW(number->value()) << command->name() << " " << option->name;
      }
      const bool is_choice = number == nullptr && dynamic_cast<const Text*>(option) == nullptr;
      if (!is_choice) continue;
      EXPECT_EQ(1, std::count(option->words.begin(), option->words.end(), option->default_value))
          << command->name() << " " << option->name;
    }
  }
}

TEST(Options, OfAGroupAreTheCommandsOwn) {
  const CommandPointer fit = find_command("fit");
  for (const char* name : {"o", "effects", "seed", "levels", "report", "json", "latitude"}) {
    EXPECT_NE(fit->find_option(name), nullptr) << name;
  }
  EXPECT_TRUE(fit->find_option("latitude")->rare);
  EXPECT_FALSE(fit->find_option("effects")->rare);
  EXPECT_FALSE(find_command("compare")->find_option("latitude")->rare);
}

// Values are stored by the parser and checked when they are used.
struct Sample : Command {
  Sample() : Command("sample", {"", 0, 1}, "", "") {}
  int run() const override { return 0; }

  Number average{this, {"average", "S", "", "10"}, {1, 100}};
  Integer<int> count{this, {"count", "N", "", "2"}, 0, 5};
  Choice<bool> direction{this, {"axis", "up|down", "", "up"}, {{"up", true}, {"down", false}}};
  Texts effects{this, {"effect", "LIST", ""}};
  Text model{this, {"model", "MODEL", ""}};
  Flag force{this, "force", ""};
};

TEST(Options, AreTheirDefaultsUntilGiven) {
  Sample sample;
  parse(sample, {});
  EXPECT_EQ(sample.average.value(), 10);
  EXPECT_FALSE(sample.average.find());
  EXPECT_EQ(sample.count.value(), 2);
  EXPECT_TRUE(sample.direction.value());
  EXPECT_TRUE(sample.effects.value().empty());
  EXPECT_FALSE(sample.force.given());
}

TEST(Options, AreReadAsTheirTypes) {
  Sample sample;
  parse(sample, {"--average=2.5", "--effect", "a", "--count", "5", "--axis", "down", "--force",
                 "--effect=b", "word"});
  EXPECT_EQ(sample.average.find(), 2.5);
  EXPECT_EQ(sample.count.find(), 5);
  EXPECT_FALSE(sample.direction.value());
  EXPECT_EQ(sample.effects.value(), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(sample.force.given());
  EXPECT_EQ(sample.arguments, std::vector<std::string>{"word"});
}

// With default options the fit is the same from the command line and from the library.
TEST(Options, OfAFitHaveTheDefaultsOfItsRequest) {
  struct FitSample : Command {
    FitSample() : Command("sample", {"", 0, 1}, "", "") {}
    int run() const override { return 0; }
    FitOptions fit{this};
  } sample;
  parse(sample, {"--effects", "bias"});
  const workflow::FitRequest own = sample.fit.request({}, {});
  const workflow::FitRequest usual;
  EXPECT_EQ(own.average_s, usual.average_s);
  EXPECT_EQ(own.derivative_tau_s, usual.derivative_tau_s);
  EXPECT_EQ(own.network_inputs, usual.network_inputs);
  EXPECT_EQ(own.hidden, usual.hidden);
  EXPECT_EQ(own.trainer, usual.trainer);
  EXPECT_EQ(own.activation, usual.activation);
  EXPECT_EQ(own.row_denoising, usual.row_denoising);
  EXPECT_EQ(own.board_denoiser.wavelet, usual.board_denoiser.wavelet);
  EXPECT_EQ(own.board_denoiser.levels, usual.board_denoiser.levels);
  EXPECT_EQ(own.board_denoiser.rule, usual.board_denoiser.rule);
  EXPECT_EQ(own.board_denoiser.hard, usual.board_denoiser.hard);
  EXPECT_EQ(own.training.seed, usual.training.seed);
  EXPECT_EQ(own.training.epochs, usual.training.epochs);
  EXPECT_EQ(own.training.goal, usual.training.goal);
  EXPECT_EQ(own.training.learning_rate, usual.training.learning_rate);
  EXPECT_EQ(own.training.particles, usual.training.particles);
  EXPECT_EQ(own.training.iterations, usual.training.iterations);
}

TEST(Options, SayWhatTheyTake) {
  Sample sample;
  parse(sample, {"--average", "0.5", "--count", "1.5", "--axis", "uq"});
  EXPECT_THROW(sample.average.value(), InputError);
  EXPECT_THROW(sample.count.value(), InputError);
  EXPECT_THROW(sample.direction.value(), InputError);
  EXPECT_THROW(sample.model.required(), InputError);
  Sample twice;
  EXPECT_EQ(refusal(twice, {"--average", "1", "--average", "2"}),
            "fogcomp sample: --average is given twice; see fogcomp sample --help");
  Sample mistyped;
  EXPECT_EQ(
      refusal(mistyped, {"--averag", "1"}),
      "fogcomp sample: unknown option --averag (did you mean '--average'?); see fogcomp sample "
      "--help");
}

}  // namespace
}  // namespace fogcomp::cli
