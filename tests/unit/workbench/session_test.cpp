// What a page of the workbench asks for is what the commands do: the same models to the byte, the
// same words.

#include "workbench/session.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "model/model_file.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"
#include "unit/recording/temporary_file.hpp"

namespace fogcomp::workbench {
namespace {

using Words = std::vector<std::string>;

// A gyro that follows the temperature and its rate, in rows of 10 s.
class Workbench : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    write_run("run.csv", 0.7);
    write_run("other.csv", 0.8);
  }

  static std::string path(const std::string& name) { return recording::temporary_path(name); }

  // `jump_dph`: of the bias, at 8000 s.
  static void write_run(const std::string& name, double swing, double jump_dph = 0,
                        double noise_dph = 0.02) {
    std::ofstream file(path(name));
    file << "time_s,temperature_degc,rate_dph\n";
    std::uint32_t draw = 12345;
    for (int row = 0; row < 1500; ++row) {
      const double phase = swing * row / 100.0;
      draw = draw * 1664525U + 1013904223U;
      const double noise = draw / 4294967296.0 - 0.5;
      const double bias = 0.5 + (row >= 800 ? jump_dph : 0);
      const double rate = bias + 0.01 * std::sin(phase) + 0.2 * std::cos(phase) + noise_dph * noise;
      file << format("%d,%.5f,%.6f\n", 10 * row, 20 + 30 * std::sin(phase), rate);
    }
  }

  // By the shell's command.
  static void run(const std::string& name, const Words& words) {
    const cli::CommandPointer command = cli::find_command(name);
    cli::parse(*command, words);
    testing::internal::CaptureStdout();
    command->run();
    testing::internal::GetCapturedStdout();
  }

  std::string ask(const Words& words) { return session_.answer(words); }
  static bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  Session session_;
};

TEST_F(Workbench, FitsTheModelThatTheCommandFits) {
  const Words what{path("run.csv"), "--effects", "bias,bias_temperature:order=2", "-o"};
  Words shell = what;
  shell.push_back(path("shell.model"));
  run("fit", shell);
  Words page{"fit"};
  page.insert(page.end(), what.begin(), what.end());
  page.push_back(path("page.model"));
  for (int time = 0; time < 2; ++time) {  // the second one with rows that are there
    const std::string answer = ask(page);
    EXPECT_FALSE(holds(answer, "\"error\"")) << answer;
    EXPECT_EQ(read_file(path("page.model")), read_file(path("shell.model")));
  }
}

// What an earlier fit has computed of these rows, or of others, changes no digit.
TEST_F(Workbench, FitsAfterOtherFits_AsTheCommandDoes) {
  const std::vector<Words> fits{{"--effects", "bias"},
                                {"--effects", "bias,thermal_lag"},
                                {"--effects", "bias,bias_temperature,temperature_rate"},
                                {"--effects", "bias,temperature_rate", "--derivative-tau", "60"},
                                {"--effects", "bias,thermal_lag", "--average", "20"}};
  for (const Words& what : fits) {
    Words shell{path("run.csv"), "-o", path("after_shell.model")};
    shell.insert(shell.end(), what.begin(), what.end());
    run("fit", shell);
    Words page{"fit", path("run.csv"), "-o", path("after.model")};
    page.insert(page.end(), what.begin(), what.end());
    ask(page);
    EXPECT_EQ(read_file(path("after.model")), read_file(path("after_shell.model"))) << what[1];
  }
}

TEST_F(Workbench, TellsTheCorrelationsOfAllParameters) {
  const std::string answer = ask(
      {"fit", path("run.csv"), "--effects", "bias,thermal_lag", "-o", path("correlated.model")});
  EXPECT_TRUE(holds(answer,
                    "\"correlations\":{\"names\":[\"bias b0\",\"thermal_lag K\","
                    "\"thermal_lag tau\"],\"rows\":[[1,"))
      << answer;
}

TEST_F(Workbench, RunsOfTwoGyros_AreNoticedByTheirNoise) {
  write_run("loud.csv", 0.7, 0, 0.2);
  const auto fitted_to = [&](const std::string& other) {
    return ask({"fit", path("run.csv"), path(other), "--effects", "bias", "-o", path("two.model")});
  };
  EXPECT_TRUE(holds(fitted_to("loud.csv"), "loud.csv has 10 times the noise of "));
  EXPECT_FALSE(holds(fitted_to("other.csv"), "times the noise of"));
}

TEST_F(Workbench, ALargeRecording_IsAveragedToOneSecond) {
  std::ofstream file(path("large.csv"));
  file << "time_s,temperature_degc,rate_dph\n";
  for (int row = 0; row < 200000; ++row) {
    file << format("%.2f,%.5f,%.6f\n", 0.05 * row, 20 + 0.0001 * row, 0.5 + 0.1 * (row % 2));
  }
  file.close();
  EXPECT_TRUE(holds(ask({"columns", path("large.csv")}), "\"large\":true"));
  EXPECT_TRUE(holds(ask({"columns", path("run.csv")}), "\"large\":false"));
  const std::string answer = ask({"means", path("large.csv")});
  EXPECT_TRUE(holds(answer, "has 200000 samples; the workbench has their 10000 means over 1 s"))
      << answer.substr(answer.size() - 400);
}

TEST_F(Workbench, AddsWhatTheCommandAddsAndSaysWhyNot) {
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("base.model")});
  const Words more{path("base.model"), "temperature_rate", path("run.csv"),
                   "--holdout",        path("other.csv"),  "-o"};
  Words shell = more;
  shell.push_back(path("shell2.model"));
  run("add", shell);
  Words page{"add"};
  page.insert(page.end(), more.begin(), more.end());
  page.push_back(path("page2.model"));
  EXPECT_TRUE(holds(ask(page), "\"accepted\":true"));
  EXPECT_EQ(read_file(path("page2.model")), read_file(path("shell2.model")));
  const std::string refused =
      ask({"add", path("page2.model"), "aging", path("run.csv"), "-o", path("none.model")});
  EXPECT_TRUE(holds(refused, "\"accepted\":false")) << refused;
}

TEST_F(Workbench, ComparesWithAColumnForEveryPlot) {
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("plot.model")});
  const std::string answer =
      ask({"compare", path("plot.model"), path("run.csv"), path("other.csv")});
  EXPECT_TRUE(holds(answer, "\"found\"") || holds(answer, "\"words\"")) << answer;
  for (std::size_t run = 0; run < 2; ++run) {
    for (const char* name : {"time_s", "measured_dph", "modelled_dph", "residual_dph", "branch",
                             "temperature_degc", "temperature_rate", "outlier", "gap_before"}) {
      const std::vector<double>* const column = session_.column(run, name);
      ASSERT_NE(column, nullptr) << name;
      EXPECT_EQ(column->size(), 1500U) << name;
    }
  }
  EXPECT_EQ(session_.column(2, "time_s"), nullptr);
  EXPECT_EQ(session_.column(0, "magnetic"), nullptr);
}

TEST_F(Workbench, DiagnosesInWordsAndSaysWhatToAdd) {
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("ask.model")});
  const std::string answer = ask({"diagnose", path("ask.model"), path("run.csv")});
  EXPECT_TRUE(holds(answer, "\"verdict\":\"Missing effect: temperature_rate")) << answer;
  EXPECT_TRUE(holds(answer, "\"add\":{\"effects\":[\"temperature_rate\"]")) << answer;
}

TEST_F(Workbench, PreviewsACandidateOverTheRowsOfTheLastComparison) {
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("hover.model")});
  ask({"compare", path("hover.model"), path("run.csv")});
  const std::string answer = ask({"preview", path("hover.model"), "temperature_rate",
                                  path("run.csv"), "-o", path("hovered.model")});
  EXPECT_FALSE(holds(answer, "\"error\"")) << answer;
  const std::vector<double>* const preview = session_.column(0, "preview");
  ASSERT_NE(preview, nullptr);
  EXPECT_EQ(preview->size(), session_.column(0, "time_s")->size());
  EXPECT_GT(*std::max_element(preview->begin(), preview->end()), 0.1);
}

// The words with which `fit` makes the model's terms anew.
TEST_F(Workbench, NamesTheTermsAsFitTakesThem) {
  const std::string list = "bias,bias_temperature:order=3,thermal_lag:tau=600";
  const std::string answer =
      ask({"fit", path("run.csv"), "--effects", list, "-o", path("terms.model")});
  for (const std::string& words : split(list, ',')) {
    EXPECT_TRUE(holds(answer, "\"words\":\"" + words + "\"")) << answer;
  }
}

TEST_F(Workbench, ARunWithAJump_IsFittedAndJudgedWithACut) {
  write_run("jump.csv", 0.7, 0.3);
  const auto asked = [&](const Words& words) {
    Words all = words;
    for (const char* word : {"--mask", "0..300"}) all.emplace_back(word);
    return ask(all);
  };
  const std::string effects = "bias,temperature_rate";
  EXPECT_TRUE(
      holds(asked({"fit", path("jump.csv"), "--effects", effects, "-o", path("flat.model")}),
            "\"run_offsets_dph\":[]"));
  EXPECT_TRUE(holds(asked({"add", path("flat.model"), path("jump.csv"), "--cut", "7995", "-o",
                           path("cut.model")}),
                    "\"accepted\":true"));
}

TEST_F(Workbench, AppliesAndExportsAsTheCommandsDo) {
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("out.model")});
  run("apply", {path("out.model"), path("run.csv"), "-o", path("shell.csv")});
  run("export", {path("out.model"), "-o", path("shell.h")});
  testing::internal::CaptureStdout();
  const std::string series =
      ask({"apply", path("out.model"), path("run.csv"), "-o", path("page.csv")});
  const std::string header = ask({"export", path("out.model"), "-o", path("page.h")});
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(series, Json::object()
                        .set("text", read_file(path("shell.csv")))
                        .set("remarks", Json::array())
                        .text());
  EXPECT_EQ(
      header,
      Json::object().set("text", read_file(path("shell.h"))).set("remarks", Json::array()).text());
}

TEST_F(Workbench, AnswersWhatIsWrongInOneLine) {
  EXPECT_EQ(ask({}), "{\"error\":\"fogcomp: no command\"}");
  EXPECT_TRUE(holds(ask({"flash", "x"}), "no command 'flash' in the workbench"));
  EXPECT_TRUE(holds(ask({"fit", path("run.csv"), "--effects", "temprate", "-o", path("x.model")}),
                    "\"error\":\""));
  EXPECT_TRUE(holds(ask({"compare", path("missing.model"), path("run.csv")}), "\"error\":\""));
  run("fit", {path("run.csv"), "--effects", "bias", "-o", path("formula.model")});
  EXPECT_TRUE(holds(ask({"formula", path("formula.model"), "x = T*T*"}), "column 9"));
  EXPECT_EQ(ask({"formula", path("formula.model"), "x = T*T*dTdt"}), "{\"remarks\":[]}");
}

TEST_F(Workbench, LeavesMaskedRowsOutAsTheCommandDoes) {
  const Words what{path("run.csv"), "--effects",  "bias,temperature_rate",
                   "--mask",        "3000..6000", "-o"};
  Words shell = what;
  shell.push_back(path("masked_shell.model"));
  run("fit", shell);
  Words page{"fit"};
  page.insert(page.end(), what.begin(), what.end());
  page.push_back(path("masked.model"));
  ask(page);
  EXPECT_EQ(read_file(path("masked.model")), read_file(path("masked_shell.model")));
  ask({"compare", path("masked.model"), path("run.csv"), "--mask", "3000..6000"});
  for (const double time_s : *session_.column(0, "time_s")) {
    EXPECT_TRUE(time_s < 3000 || time_s > 6000);
  }
  EXPECT_EQ(session_.column(0, "time_s")->size(), 1500U - 301U);
}

}  // namespace
}  // namespace fogcomp::workbench
