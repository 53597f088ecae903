#include "cli/axes.hpp"

#include <gtest/gtest.h>

#include "cli/command.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

std::vector<std::string> call_lines(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const AxisCall& call : axis_calls(words)) all.push_back(join(call.words, " "));
  return all;
}

TEST(Axes, SeveralNames_MakeACallForEach) {
  EXPECT_EQ(
      call_lines({"run.csv", "--rate-column", "x,Gyro_Y [deg/s]", "-o", "gyro_%.model"}),
      (std::vector<std::string>{"run.csv --rate-column x -o gyro_x.model",
                                "run.csv --rate-column Gyro_Y [deg/s] -o gyro_Gyro_Y.model"}));
  EXPECT_EQ(call_lines({"%.model", "run.csv", "--rate-column=a.b,c"}),
            (std::vector<std::string>{"a_b.model run.csv --rate-column=a.b",
                                      "c.model run.csv --rate-column=c"}));
}

TEST(Axes, OneName_ChangesNothing) {
  EXPECT_EQ(call_lines({"100%.csv", "--rate-column", "x"}),
            std::vector<std::string>{"100%.csv --rate-column x"});
  EXPECT_EQ(call_lines({"100%.csv"}), std::vector<std::string>{"100%.csv"});
  EXPECT_THROW(axis_calls({"run.csv", "--rate-column", "x,,y"}), InputError);
}

TEST(Axes, OutputsOfTwo_AreTwoFiles) {
  const auto require = [](const std::vector<std::string>& words) {
    std::vector<CommandPointer> commands;
    for (const AxisCall& call : axis_calls(words)) {
      commands.push_back(find_command("fit"));
      parse(*commands.back(), call.words);
    }
    require_own_outputs(commands);
  };
  const std::vector<std::string> start{"run.csv",       "--effects", "bias",
                                       "--rate-column", "x,y",       "-o"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    return more;
  };
  EXPECT_NO_THROW(require(with({"%.model"})));
  EXPECT_THROW(require(with({"gyro.model"})), InputError);
  EXPECT_NO_THROW(require(with({"%.model", "--report", "page.html"})));  // one page of both
  EXPECT_THROW(require(with({"%.model", "--json"})), InputError);
}

}  // namespace
}  // namespace fogcomp::cli
