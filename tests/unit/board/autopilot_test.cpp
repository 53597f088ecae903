#include "board/autopilot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/typical_effects.hpp"

namespace fogcomp::board {
namespace {

constexpr double kDphPerRadps = 180 / 3.14159265358979323846 * 3600;

AxisModel axis_model(double bias, const std::vector<double>& coefficients) {
  AxisModel one;
  one.file = "x.model";
  one.model.min_degc = -30;
  one.model.max_degc = 60;
  model::EffectTerm constant = fog::test::natural_term("bias", {}, {bias});
  model::EffectTerm polynomial = fog::test::natural_term(
      "bias_temperature", {static_cast<double>(coefficients.size())}, coefficients);
  one.model.terms = {constant, polynomial};
  return one;
}

std::array<AxisModel, 3> imu() {
  return {axis_model(100, {2, -0.03, 4e-4}), axis_model(-50, {1, 0.02}), axis_model(7, {-0.5})};
}

// deg/h, as the models say.
double drift_dph(std::size_t axis, double degc) {
  const double t = degc - 20;
  if (axis == 0) return 100 + 2 * t - 0.03 * t * t + 4e-4 * t * t * t;
  return axis == 1 ? -50 + t + 0.02 * t * t : 7 - 0.5 * t;
}

// Values by name; the columns of a line are at `name` and `value`.
std::map<std::string, double> values_in(const std::string& text, char separator, std::size_t name) {
  std::map<std::string, double> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line[0] == '#') continue;
    const std::vector<std::string> fields = split(line, separator);
    found[fields.at(name)] = *parse_number(fields.at(name + 1));
  }
  return found;
}

TEST(Autopilot, OfPx4_TakesOutTheDrift) {
  const auto all = values_in(autopilot_parameters(Autopilot::px4, imu()), '\t', 2);
  EXPECT_EQ(all.at("TC_G_ENABLE"), 1);
  EXPECT_EQ(all.at("TC_G0_TMIN"), -30);
  EXPECT_EQ(all.at("TC_G0_TMAX"), 60);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double degc : {-30.0, 20.0, 55.0}) {
      double offset = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        offset += all.at(format("TC_G0_X%zu_%zu", k, axis)) *
                  std::pow(degc - all.at("TC_G0_TREF"), static_cast<double>(k));
      }
      EXPECT_NEAR(offset * kDphPerRadps, drift_dph(axis, degc), 1e-4) << axis << " " << degc;
    }
  }
}

TEST(Autopilot, OfArduPilot_TakesOutTheDriftSinceItsStart) {
  const auto all = values_in(autopilot_parameters(Autopilot::ardupilot, imu()), ',', 0);
  EXPECT_EQ(all.at("INS_TCAL1_ENABLE"), 1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto offset = [&](double degc) {
      double sum = 0;
      for (std::size_t k = 1; k < 4; ++k) {
        sum += all.at(format("INS_TCAL1_GYR%zu_%c", k, "XYZ"[axis])) *
               std::pow(degc - 35, static_cast<double>(k));
      }
      return sum * 1e-6 * kDphPerRadps;
    };
    for (const double degc : {-30.0, 20.0, 55.0}) {
      EXPECT_NEAR(offset(degc) - offset(10), drift_dph(axis, degc) - drift_dph(axis, 10), 1e-4);
    }
  }
}

std::string autopilot_refusal(const AxisModel& one) {
  try {
    autopilot_parameters(Autopilot::px4, {imu()[1], one, imu()[2]});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Autopilot, OfAnythingElse_Refused) {
  AxisModel other = imu()[0];
  other.model.terms.push_back(fog::test::natural_term("temperature_rate", {}, {0.1}));
  EXPECT_EQ(autopilot_refusal(other),
            "x.model: has the effect temperature_rate; an autopilot takes a polynomial in "
            "temperature alone: fit with --effects bias,bias_temperature:order=3");
  EXPECT_NE(autopilot_refusal(axis_model(1, {1, 1, 1, 1})).find("has a polynomial of degree 4;"),
            std::string::npos);
  AxisModel warm = imu()[0];
  warm.model.min_degc = 70;
  warm.model.max_degc = 80;
  EXPECT_NE(autopilot_refusal(warm).find("trained at no common temperature"), std::string::npos);
}

}  // namespace
}  // namespace fogcomp::board
