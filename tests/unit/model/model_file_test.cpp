#include "model/model_file.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "board/table_files.hpp"
#include "core/bytes/crc.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"
#include "support/text.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::model {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_model(text, "gyro.model");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ModelFile, ReadsBackToTheSameBits) {
  const std::string text = model_text(fog::test::paper_like_model());
  EXPECT_EQ(model_text(parse_model(text, "gyro.model")), text);
}

// A file from before ranges of rate and time, noise floors and holdouts were kept.
TEST(ModelFile, ReadsAFileWithoutTheLaterEntries) {
  Model model = fog::test::paper_like_model();
  const std::string old = model_text(model);
  EXPECT_EQ(old.find("range_s"), std::string::npos);
  EXPECT_EQ(old.find("history_"), std::string::npos);
  const Model read = parse_model(old, "old.model");
  EXPECT_FALSE(read.rate_range_degc_per_min.has_value());
  EXPECT_FALSE(read.history[0].excess_removed().has_value());
}

void expect_that_reads_as_now(const EffectTerm& term, const std::string& before,
                              const std::string& now) {
  Model model = fog::test::paper_like_model();
  model.terms = {term};
  std::string text = model_text(model);
  const std::size_t at = text.find(now);
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, now.size(), before);
  text.erase(text.rfind("crc "));
  const std::uint32_t crc =
      fog::crc32(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const Model read = parse_model(text + format("crc %08x\n", crc), "old.model");
  EXPECT_EQ(model_text(read), model_text(model));
}

TEST(ModelFile, ReadsEffectsFromBeforeTheyHadAllTheirParameters) {
  for (const char* const before : {"effect scale_factor_temperature 0 1 ",
                                   "effect scale_factor_temperature 2 1 20 0 0 0 0 1 "}) {
    expect_that_reads_as_now(fog::test::natural_term("scale_factor_temperature", {1, 20, 0}, {300}),
                             before, "effect scale_factor_temperature 3 1 20 0 0 0 0 0 0 0 1 ");
  }
  expect_that_reads_as_now(fog::test::natural_term("aging", {7200, 1}, {0.1}),
                           "effect aging 1 7200 0 0 1 ", "effect aging 2 7200 1 0 0 0 0 1 ");
}

TEST(ModelFile, KeepsTheWholeHistory) {
  Model model = fog::test::paper_like_model();
  model.rate_range_degc_per_min = Range{-0.7, 0.9};
  model.time_range_s = Range{5, 36005};
  model.input_rate_range_dph = Range{-72000, 72000};
  model.history.push_back({"add thermal_lag:tau=300", 0xFFFFFFFF, 0.024, 0.0205, 0.02,
                           HistoryEntry::Holdout{0.027, 0.026}, true});
  const std::string text = model_text(model);
  const Model read = parse_model(text, "gyro.model");
  EXPECT_EQ(model_text(read), text);
  EXPECT_EQ(read.rate_range_degc_per_min->max, 0.9);
  EXPECT_EQ(read.time_range_s->min, 5);
  EXPECT_EQ(read.input_rate_range_dph->max, 72000);
  ASSERT_EQ(read.history.size(), 2U);
  EXPECT_FALSE(read.history[0].noise_floor_dph.has_value());
  EXPECT_EQ(read.history[1].action, "add thermal_lag:tau=300");
  EXPECT_EQ(read.history[1].holdout->rms_after_dph, 0.026);
  EXPECT_TRUE(read.history[1].forced);
  // 0.024^2 - 0.0205^2 = 1.5575e-4 of 0.024^2 - 0.02^2 = 1.76e-4.
  EXPECT_NEAR(read.history[1].excess_removed().value_or(0), 0.88494, 1e-5);
}

TEST(ModelFile, KeepsTheRecordingOfAnEvent) {
  Model model = fog::test::paper_like_model();
  model.terms.push_back(fog::test::natural_term("bias_step", {15000}, {0.2}));
  model.terms.back().recording = 0xFEDCBA9876543210;
  const std::string text = model_text(model);
  const Model read = parse_model(text, "gyro.model");
  EXPECT_EQ(read.terms.back().recording, model.terms.back().recording);
  EXPECT_EQ(read.terms.back().others_part, 0);
  EXPECT_EQ(model_text(read), text);
  for (const double part : {1.0, 0.4}) {
    model.terms.back().others_part = part;
    EXPECT_EQ(parse_model(model_text(model), "gyro.model").terms.back().others_part, part);
  }
  model.terms.push_back(fog::test::natural_term("aging", {3600}, {0.1}));
  model.terms.back().recording = 1;
  const std::string error = error_of(model_text(model));
  EXPECT_NE(error.find("belongs behind an event"), std::string::npos) << error;
}

TEST(ModelFile, KeepsTheGyrosOwnValuesBesideTheBoards) {
  Model model = fog::test::paper_like_model();
  EffectTerm& term = model.terms.back();
  GyroValues& gyro = term.gyro.emplace();
  for (const Parameter& parameter : term.parameters)
    gyro.shape.emplace_back(1.01 * parameter.value, 0.5);
  for (const Estimate& coefficient : term.coefficients_dph)
    gyro.coefficients_dph.emplace_back(2 * coefficient.value, 0.25);
  const Model read = parse_model(model_text(model), "gyro.model");
  ASSERT_TRUE(read.terms.back().gyro);
  EXPECT_EQ(read.terms.back().shape(), term.shape());
  EXPECT_EQ(read.terms.back().coefficients(), term.coefficients());
  EXPECT_EQ(of_gyro(read.terms.back()).shape(), of_gyro(term).shape());
  EXPECT_EQ(natural_coefficient(read.terms.back(), 0).value, natural_coefficient(term, 0).value);
  EXPECT_EQ(model_text(read), model_text(model));
}

TEST(ModelFile, KeepsTheUncertaintyOfItsOwnUnknownsOnly) {
  Model model = fog::test::paper_like_model();
  const Eigen::Index unknowns = unknowns_of(model);
  model.uncertainty =
      Model::Uncertainty{Eigen::MatrixXd::Identity(unknowns, unknowns), 0.02, 0.003, 0.01, 0.1};
  model.uncertainty->covariance(1, 0) = model.uncertainty->covariance(0, 1) = 0.25;
  const Model read = parse_model(model_text(model), "gyro.model");
  ASSERT_TRUE(read.uncertainty);
  EXPECT_EQ(read.uncertainty->covariance, model.uncertainty->covariance);
  EXPECT_EQ(read.uncertainty->turn_on_dph, 0.1);
  model.uncertainty->covariance.resize(unknowns - 1, unknowns - 1);
  model.uncertainty->covariance.setIdentity();
  EXPECT_NE(error_of(model_text(model)).find("the uncertainty is of another model"),
            std::string::npos);
}

TEST(ModelFile, KeepsTheLimitsOfTheGyro) {
  Model model = fog::test::paper_like_model();
  model.limits = {200, 2500};
  const std::string text = model_text(model);
  const Model read = parse_model(text, "gyro.model");
  EXPECT_EQ(model_text(read), text);
  EXPECT_EQ(read.limits.range_dps, 200);
  EXPECT_EQ(read.limits.max_acceleration_dps2, 2500);
}

TEST(ModelFile, KeepsWhatTrainingCoveredOfAnInput) {
  Model model = fog::test::paper_like_model();
  model.input_ranges[extension_number(fog::Input::supply)] = InputRange{{4.75, 5.25}, 0.0625};
  const std::string text = model_text(model);
  EXPECT_NE(text.find("\ninput_range supply 4.75 5.25 0.0625\n"), std::string::npos);
  const Model read = parse_model(text, "gyro.model");
  EXPECT_EQ(model_text(read), text);
  EXPECT_FALSE(read.input_ranges[0].has_value());
}

TEST(ModelFile, KeepsEveryInputThatANetworkCanHave) {
  Model model = fog::test::paper_like_model();
  model.network = fog::test::network_of({{fog::NetworkInput::lagged_temperature, 10, 51, 300},
                                         {fog::NetworkInput::elapsed, 30000, 30000, 0},
                                         {fog::NetworkInput::input_rate, 8.5, 10, 0}});
  const std::string text = model_text(model);
  EXPECT_EQ(model_text(parse_model(text, "gyro.model")), text);
  EXPECT_EQ(parse_model(text, "gyro.model").network.inputs[0].tau_s, 300);
}

TEST(ModelFile, KeepsExpressions) {
  Model model = fog::test::paper_like_model();
  model.terms.push_back(fog::test::written_term("late = lag(T, ?tau[60, 900]) -  T2 * exp(-t/7)"));
  const std::string text = model_text(model);
  const Model read = parse_model(text, "gyro.model");
  EXPECT_EQ(model_text(read), text);
  EXPECT_EQ(read.terms.back().expression->ranges[4].max, 110);
  EXPECT_EQ(read.terms.back().expression->scale_log2, model.terms.back().expression->scale_log2);
}

TEST(ModelFile, RefusesAScaleThatNoNumberHas) {
  Model model = fog::test::expressions_model();
  model.terms.back().expression->scale_log2 = 1 << 30;
  EXPECT_NE(error_of(model_text(model)).find("whole number is out of range"), std::string::npos);
}

TEST(ModelFile, RefusesEveryDamagedByte) {
  const std::string good = model_text(fog::test::paper_like_model());
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    ASSERT_NE(error_of(damaged), "accepted") << i;
  }
  for (std::size_t size = 0; size < good.size(); ++size) {
    ASSERT_NE(error_of(good.substr(0, size)), "accepted") << size;
  }
}

TEST(ModelFile, RefusesANetworkWithoutOneOfItsParts) {
  const Model whole = fog::test::paper_like_model();
  Model model = whole;
  model.network.inputs.clear();
  EXPECT_NE(error_of(model_text(model)).find("part of the network is missing"), std::string::npos);
  model = whole;
  model.network.output = {};
  EXPECT_NE(error_of(model_text(model)).find("part of the network is missing"), std::string::npos);
}

// The CRC is right in all of these: they were written so.
TEST(ModelFile, RefusesValuesThatNoFitGives) {
  struct Case {
    const char* what;
    std::function<void(Model&)> change;
    const char* said;
  };
  const auto term = [](Model& model, const std::string& name) -> EffectTerm& {
    model.terms = parse_effects(name);
    const std::size_t count = make_effect(model.terms[0], 1)->regressor_count();
    model.terms[0].coefficients_dph.assign(count, {0.1, 0.01});
    return model.terms[0];
  };
  const Case cases[] = {
      {"order -1", [&](auto& m) { term(m, "bias_temperature").parameters[0].value = -1; },
       "order is -1, outside 1 to 9;"},
      {"order 1e6", [&](auto& m) { term(m, "bias_temperature").parameters[0].value = 1e6; },
       "order is 1e+06, outside 1 to 9"},
      {"order 2.5", [&](auto& m) { term(m, "bias_temperature").parameters[0].value = 2.5; },
       "order is 2.5, not a whole number"},
      {"order 3", [&](auto& m) { term(m, "bias_temperature").parameters[0].value = 3; },
       "wrong number of coefficients"},
      {"tau 0", [&](auto& m) { term(m, "thermal_lag").parameters[0].value = 0; },
       "tau is 0, outside 5 to 20000"},
      {"bias", [&](auto& m) { term(m, "bias").coefficients_dph[0].value = 1e300; },
       "1e+300 is outside"},
      {"history", [](auto& m) { m.history[0].rms_after_dph = 1e308; }, "1e+308 is outside"},
      {"range", [](auto& m) { m.max_degc = 1e300; }, "no gyro is so cold or hot"},
      {"rows", [](auto& m) { m.average_s = 1e9; }, "1e+09 is outside"},
      {"weight", [](auto& m) { m.network.hidden.weights(0, 0) = -1e300; }, "-1e+300 is outside"},
      {"drift", [](auto& m) { m.network.amplitude_dph = 1e300; }, "1e+300 is outside"},
  };
  for (const Case& one : cases) {
    Model model = fog::test::paper_like_model();
    one.change(model);
    const std::string error = error_of(model_text(model));
    EXPECT_NE(error.find(one.said), std::string::npos) << one.what << ": " << error;
    EXPECT_EQ(error.find("gyro.model:"), 0U) << error;
  }
  Model model = fog::test::expressions_model();
  model.terms.push_back(fog::test::written_term("x = lag(T, ?tau[60, 900])"));
  model.terms.back().parameters[0].value = 1e9;
  EXPECT_NE(error_of(model_text(model)).find("'tau' is outside its bounds"), std::string::npos);
}

TEST(ModelFile, IsReadWithTheLineEndsOfAMail) {
  const std::string text = model_text(fog::test::paper_like_model());
  std::string mailed;
  for (const char c : text) mailed += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(model_text(parse_model(mailed, "gyro.model")), text);
}

TEST(ModelFile, NamesFileLineAndRemedy) {
  EXPECT_EQ(error_of("time_s,rate_dph\n"),
            "gyro.model: is not a fogcomp model; fogcomp fit makes one");
  EXPECT_EQ(error_of("fogcomp-model 9\ncrc 0\n"),
            "gyro.model:1: is a model of another version ('fogcomp-model 9', this fogcomp reads "
            "'fogcomp-model 2'); fit it again");
}

TEST(Header, ReadsBackToTheSameTable) {
  const board::BoardTable table = board::make_board_table(fog::test::paper_like_model(), {});
  const std::string text = board::header_text(table, "gyro.model", 0x1234);
  EXPECT_EQ(board::parse_header(text, "fog_model.h").words, table.words);
}

TEST(Header, RefusesAChangedNumber) {
  const board::BoardTable table = board::make_board_table(fog::test::paper_like_model(), {});
  std::string text = board::header_text(table, "gyro.model", 0x1234);
  const std::size_t digit = text.find("2101248000");
  ASSERT_NE(digit, std::string::npos);
  text[digit] = '1';
  try {
    board::parse_header(text, "fog_model.h");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "fog_model.h: model table damaged (CRC); export the header again");
  }
}

}  // namespace
}  // namespace fogcomp::model
