#include "model/effect_list.hpp"

#include <gtest/gtest.h>

namespace fogcomp::model {
namespace {

TEST(EffectList, BlanksMeanNothing) {
  const auto plain = parse_effects("bias,bias_temperature:order=2,thermal_lag:tau=?[60,900]");
  const auto blanks =
      parse_effects(" bias , bias_temperature : order = 2,\tthermal_lag: tau = ? [60, 900]");
  ASSERT_EQ(blanks.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(blanks[i].name, plain[i].name);
    EXPECT_EQ(blanks[i].parameters, plain[i].parameters);
    EXPECT_EQ(blanks[i].identified, plain[i].identified);
  }
  EXPECT_EQ(blanks[2].bounds[0].max, 900);
}

}  // namespace
}  // namespace fogcomp::model
