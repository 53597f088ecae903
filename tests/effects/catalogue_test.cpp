#include "model/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/drift_model.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::model {
namespace {

// Data that host and tests take from the header of an effect.
TEST(Catalogue, ExamplesAreWithinBoundsAndHaveACoefficientForEachRegressor) {
  for (const CatalogueEntry& entry : catalogue()) {
    const EffectTerm term = fog::test::example_term(entry);
    EXPECT_EQ(term.coefficients_dph.size(), RegressorBank({term}, 1).size()) << term.name;
    for (std::size_t i = 0; i < term.parameters.size(); ++i) {
      const ShapeBounds bounds = catalogue_bounds(entry, i);
      EXPECT_GE(term.parameters[i].value, bounds.min) << term.name;
      EXPECT_LE(term.parameters[i].value, bounds.max) << term.name;
    }
  }
}

TEST(Catalogue, BoundsSuitTheScaleOfTheSearchAndDefaultsTheBounds) {
  for (const CatalogueEntry& entry : catalogue()) {
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      const fog::ParameterDescription& parameter = entry.parameters[i];
      const std::string where = std::string(entry.description.name) + "." + parameter.name;
      EXPECT_GE(parameter.default_milli, parameter.min_milli) << where;
      EXPECT_LE(parameter.default_milli, parameter.max_milli) << where;
      const bool of_ratios =
          parameter.scale == fog::Scale::logarithmic || parameter.scale == fog::Scale::frequency;
      EXPECT_TRUE(!of_ratios || catalogue_bounds(entry, i).min > 0) << where;
      if (is_optional_part(parameter)) {
        EXPECT_TRUE(i > 0 && !is_optional_part(entry.parameters[i - 1])) << where;
        EXPECT_TRUE(parameter.min_milli == 0 && parameter.default_milli == 0) << where;
      }
    }
  }
}

TEST(Catalogue, ACoefficientPerDegreeAMinuteMultipliesTheTemperatureRate) {
  for (const CatalogueEntry& entry : catalogue()) {
    for (const fog::CoefficientDescription& coefficient : entry.coefficients) {
      EXPECT_EQ(of_temperature_rate(coefficient),
                std::string(coefficient.unit).find("/min)") != std::string::npos)
          << entry.description.name << ": " << coefficient.symbol;
    }
  }
}

// The search for steps has one name for them.
TEST(Catalogue, HasOneEventAtMostWhichIsAtATimeAndNotOnTheBoard) {
  int events = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.description.event) continue;
    ++events;
    ASSERT_EQ(entry.parameters.size(), 1U) << entry.description.name;
    EXPECT_STREQ(entry.parameters[0].unit, "s") << entry.description.name;
    EXPECT_EQ(entry.coefficients.size(), 1U) << entry.description.name;
    EXPECT_NE(entry.description.host_only, nullptr) << entry.description.name;
  }
  EXPECT_LE(events, 1);
}

fog::Scale scale_in(const std::string& definition) {
  return info_of(expression_term(definition)).parameters.at(0).scale;
}

TEST(TermInfo, AnExpressionsParameterIsSearchedAsItsFormulaAndBoundsSay) {
  EXPECT_EQ(scale_in("x = sin(6.283 * T / ?p[2,60])"), fog::Scale::frequency);
  EXPECT_EQ(scale_in("x = exp(-t/300) * cos((T - 20) / (2 * abs(?p[2,60])) + 1)"),
            fog::Scale::frequency);
  EXPECT_EQ(scale_in("x = sin(T / 7) / ?period[2,60]"), fog::Scale::logarithmic);
  EXPECT_EQ(scale_in("x = sin(?k[2,60] * T / 7)"), fog::Scale::logarithmic);
  EXPECT_EQ(scale_in("x = exp(-t / ?tau[60,900])"), fog::Scale::linear);
  EXPECT_EQ(scale_in("x = sin(T / ?p[0,60])"), fog::Scale::linear);
}

}  // namespace
}  // namespace fogcomp::model
