#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/frames/extension_frame.hpp"
#include "core/network/network_input.hpp"
#include "core/signal/inputs.hpp"

namespace {

using fog::Input;
using fog::InputDescription;
using fog::NetworkInput;

TEST(InputTable, HasOneRowForEachInputAndEveryNameOnce) {
  std::set<std::string> names;
  std::set<std::string> columns;
  std::set<std::string> symbols;
  for (const InputDescription& row : fog::kInputTable) {
    EXPECT_EQ(&row, &description_of(row.input)) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(symbols.insert(row.symbol).second) << row.symbol;
    EXPECT_TRUE(columns.insert(row.column).second) << row.column;
  }
}

TEST(InputTable, AnExtensionInputHasAColumnWithinTheFormatAndSwingsInTheCheckOfAnExport) {
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    const Input input = fog::extension_input(i);
    const InputDescription& row = description_of(input);
    EXPECT_EQ(std::string(row.column).rfind(std::string(row.name) + "_", 0), 0U) << row.column;
    EXPECT_EQ(row.fraction, fog::ExtensionValue::fractional_bits) << row.name;
    EXPECT_LT(row.min_milli, row.max_milli) << row.name;
    EXPECT_GT(row.swing.amplitude_milli, 0) << row.name;
    EXPECT_GT(row.swing.period_s, 0) << row.name;
  }
}

// Boards in the field and models on disk depend on them.
TEST(InputTable, KeepsTheNumbersOfRecordsProgramsAndNetworks) {
  constexpr Input kInOrder[] = {Input::temperature, Input::temperature_rate, Input::elapsed,
                                Input::input_rate,  Input::temperature2,     Input::magnetic,
                                Input::light_power, Input::supply,           Input::vibration};
  for (std::size_t i = 0; i < std::size(kInOrder); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kInOrder[i]), i);
  }
  EXPECT_EQ(fog::encode_extension_frame({Input::temperature2, {}})[2], 0);
  EXPECT_EQ(fog::encode_extension_frame({Input::vibration, {}})[2], 4);
  EXPECT_EQ(fog::network_input(Input::temperature_rate), NetworkInput::temperature_rate);
  EXPECT_EQ(fog::network_input(Input::elapsed), NetworkInput::elapsed);
  EXPECT_EQ(fog::network_input(Input::input_rate), NetworkInput::input_rate);
  for (std::size_t i = 0; i < fog::kInputs; ++i) {
    const auto input = static_cast<Input>(i);
    EXPECT_EQ(input_of(fog::network_input(input)), input);
  }
  EXPECT_EQ(input_of(NetworkInput::lagged_temperature), Input::temperature);
}

}  // namespace
