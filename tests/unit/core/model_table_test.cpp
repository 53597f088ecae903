#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "core/compensation/drift_model.hpp"
#include "core/pipeline/model_needs.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "support/sample_models.hpp"
#include "support/typical_effects.hpp"

namespace {

using fog::ModelError;

ModelError read(const std::vector<std::int32_t>& words,
                const fog::ModelShape& capacity = fog::kAnyModel) {
  fog::ModelParameters parameters;
  return fog::read_model({words.data(), words.size()}, capacity, parameters);
}

std::vector<std::int32_t> good_words() {
  return fogcomp::board::make_board_table(fog::test::paper_like_model(), {}).words;
}

std::vector<std::int32_t> words_with_expressions() {
  return fogcomp::board::make_board_table(fog::test::expressions_model(), {}).words;
}

void repair_crc(std::vector<std::int32_t>& words) {
  words.back() = static_cast<std::int32_t>(fog::model_table_crc({words.data(), words.size()}));
}

TEST(ModelTable, IsRefusedForEveryFlippedBit) {
  const auto good = good_words();
  ASSERT_EQ(read(good), ModelError::none);
  for (std::size_t word = 0; word < good.size(); ++word) {
    for (unsigned bit = 0; bit < 32; ++bit) {
      auto damaged = good;
      damaged[word] =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(damaged[word]) ^ (1U << bit));
      ASSERT_NE(read(damaged), ModelError::none) << word << ":" << bit;
    }
  }
}

TEST(ModelTable, IsRefusedWhereALaggedInputHasNoLagOrAnotherHasOne) {
  for (const std::int32_t decay : {0, 1000}) {
    for (const auto signal :
         {fog::NetworkInput::temperature, fog::NetworkInput::lagged_temperature}) {
      auto words = good_words();
      std::size_t input = 0;  // the first one's words: signal, decay, centre...
      const std::int32_t centre = 10 * 65536;
      while (words[input] != 0 || words[input + 1] != 0 || words[input + 2] != centre) ++input;
      words[input] = static_cast<std::int32_t>(signal);
      words[input + 1] = decay;
      repair_crc(words);
      const bool right = (signal == fog::NetworkInput::lagged_temperature) == (decay > 0);
      EXPECT_EQ(read(words), right ? ModelError::none : ModelError::out_of_range);
    }
  }
}

TEST(ModelTable, IsRefusedWhereItsFiltersAreNotOneFilter) {
  // From the end: CRC, 2 lines, flags, output, 5 thresholds, then 16 words each of two filters.
  const std::size_t last_synthesis = good_words().size() - 11;
  for (const std::size_t back : {0U, 16U}) {
    auto words = good_words();
    words[last_synthesis - back] += 1;
    repair_crc(words);
    EXPECT_EQ(read(words), ModelError::out_of_range) << back;
  }
}

TEST(ModelTable, SaysWhyItIsRefused) {
  auto words = good_words();
  EXPECT_EQ(read({}), ModelError::not_a_model);
  words[0] ^= 1;
  EXPECT_EQ(read(words), ModelError::not_a_model);
  words = good_words();
  words[1] = fog::kModelLayout - 1;
  repair_crc(words);
  EXPECT_EQ(read(words), ModelError::other_layout);
  words = good_words();
  words.pop_back();
  EXPECT_EQ(read(words), ModelError::damaged);
  words = good_words();
  EXPECT_EQ(read(words, {0x7, 0, 0x3, fog::filters_of(16), 5}), ModelError::none);
  EXPECT_EQ(read(words_with_expressions(), {0x7, 0, 0x3, fog::filters_of(16), 5}),
            ModelError::not_in_image);
  EXPECT_EQ(
      read(words_with_expressions(), {0x7, fog::kAllExpressions, 0x3, fog::filters_of(16), 5}),
      ModelError::none);
  EXPECT_EQ(read(words, {0x3, 0, 0x3, fog::filters_of(16), 5}), ModelError::not_in_image);
  EXPECT_EQ(read(words, {0x7, 0, 0x1, fog::filters_of(16), 5}), ModelError::not_in_image);
  EXPECT_EQ(read(words, {0x7, 0, 0x3, fog::filters_of(16), 4}), ModelError::not_in_image);
  EXPECT_EQ(read(words, {0x7, 0, 0x3, fog::filters_of(14), 5}), ModelError::not_in_image);
}

TEST(ModelTable, HasASentenceForEveryRefusal) {
  std::set<std::string> sentences;
  for (int error = 0; error <= static_cast<int>(ModelError::sample_too_dear); ++error) {
    sentences.insert(fog::describe(static_cast<ModelError>(error)));
  }
  EXPECT_EQ(sentences.size(), 10U);
  EXPECT_EQ(sentences.count("unknown"), 0U);
}

TEST(ModelTable, SaysWhatAnExpressionNeedsBesideTheTemperature) {
  const std::pair<const char*, fog::InputMask> needs[] = {
      {"a = T*dTdt", 0},
      {"a = t", fog::bit_of(fog::Input::elapsed)},
      {"a = W", fog::bit_of(fog::Input::input_rate)},
      {"a = T2", fog::bit_of(fog::Input::temperature2)},
      {"a = B", fog::bit_of(fog::Input::magnetic)},
      {"a = P", fog::bit_of(fog::Input::light_power)},
      {"a = V", fog::bit_of(fog::Input::supply)},
      {"a = g", fog::bit_of(fog::Input::vibration)}};
  for (const auto& [text, mask] : needs) {
    fogcomp::model::Model model = fog::test::paper_like_model();
    model.terms.push_back(fog::test::written_term(text));
    const auto words =
        fogcomp::board::make_board_table(model, {200, fog::OutputSelection::kvh, true}).words;
    fog::ModelParameters parameters;
    ASSERT_EQ(fog::read_model({words.data(), words.size()}, fog::kAnyModel, parameters),
              ModelError::none);
    EXPECT_EQ(fog::needs_of(parameters), mask) << text;
  }
}

// For any numbers in a table with a good CRC, reading returns a verdict, and an accepted table can
// be run. (ASan and UBSan check it in the sanitized build.)
TEST(ModelTable, WithAGoodCrcAndAnyNumbersIsReadSafely) {
  std::mt19937 random(1);
  const std::vector<std::vector<std::int32_t>> good{good_words(), words_with_expressions()};
  int accepted = 0;
  for (std::size_t i = 0; i < 40000; ++i) {
    auto words = good[i % 2];
    for (int n = static_cast<int>(random() % 3); n >= 0; --n) {
      std::int32_t& word = words[4 + random() % (words.size() - 5)];
      word = random() % 2 == 0 ? static_cast<std::int32_t>(random())
                               : word + static_cast<std::int32_t>(random() % 5) - 2;
    }
    repair_crc(words);
    fog::ModelParameters parameters;
    if (fog::read_model({words.data(), words.size()}, fog::kAnyModel, parameters) !=
        ModelError::none) {
      continue;
    }
    ++accepted;
    fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> model(
        parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
        parameters.policy);
    model.start({fog::Temperature::from_raw(static_cast<std::int32_t>(random()))});
    for (int block = 0; block < 5; ++block) {
      model.step({fog::Temperature::from_raw(static_cast<std::int32_t>(random()))});
    }
  }
  EXPECT_GT(accepted, 100);
}

}  // namespace
