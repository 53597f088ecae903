// Each effect has its characteristic signature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/input_error.hpp"
#include "unit/simulation/run_helper.hpp"

namespace fogcomp::simulation {
namespace {

// 2 h soak, a ramp of 200 min at 0.5 K/min, 4 h soak.
const char* const kOneRamp = "start 0 degC\nsoak 2 h\nramp to 100 degC at 0.5 degC/min\nsoak 4 h\n";
constexpr std::size_t kRampStart = 720;  // in rows of 10 s
constexpr std::size_t kRampEnd = 720 + 1200;

WholeRun run_text(const std::vector<std::string>& options, const std::string& profile,
                  const SimulationOptions& simulation_options = coarse()) {
  return whole_run(gyro_of(options), parse_profile(profile, "test", 1), simulation_options);
}

double largest(const std::vector<double>& values) {
  double peak = 0;
  for (const double value : values) peak = std::max(peak, std::abs(value));
  return peak;
}

double mean(const std::vector<double>& values, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) sum += values[i];
  return sum / static_cast<double>(last - first);
}

TEST(Effects, ReachThePeakAskedForInEveryCase) {
  const Programme programme = parse_profile(
      "ramp to -40 degC at 2 degC/min\nsweep 1 deg/s every 60 s\nsoak 20 min\nrate 0 deg/s\nramp "
      "to 60 degC at 2 degC/min\nsoak 20 min\n",
      "test", 1);
  SimulationOptions options = coarse();
  options.rate_hz = 1;  // so that a short spike is not averaged away
  options.earth.latitude_deg = 34.27;
  for (const EffectDescription& description : effect_catalogue()) {
    if (description.name == "bias" || description.name == "dead_band") continue;
    options.grid.axial_cells = description.name == "axial_gradient" ? 3 : 1;
    const WholeRun result =
        whole_run(gyro_of({description.name + ":peak=0.05"}), programme, options);
    const double peak = largest(result.effect(description.name));
    EXPECT_GT(peak, 0.045) << description.name;
    EXPECT_LT(peak, 0.0500001) << description.name;
  }
}

TEST(Effects, AreMultipliedByTheirScaleOnEveryProgramme) {
  for (const char* const profile : {"ramp_rates", "heater_pulses"}) {
    const auto shupe = [&](const std::string& option) {
      return whole_run(gyro_of({option}), profile_of(profile), coarse()).effect("shupe");
    };
    const std::vector<double> natural = shupe("shupe");
    const std::vector<double> scaled = shupe("shupe:scale=-3");
    for (std::size_t i = 0; i < natural.size(); ++i) {
      ASSERT_NEAR(scaled[i], -3 * natural[i], 1e-12) << profile << " " << i;
    }
  }
  EXPECT_THROW(whole_run(gyro_of({"shupe:scale=2,peak=0.05"}), profile_of("static"), coarse()),
               InputError);
}

TEST(Effects, ThatStayZeroCannotBeScaled) {
  EXPECT_THROW(
      whole_run(gyro_of({"scale_factor_temperature:peak=0.05"}), profile_of("static"), coarse()),
      InputError);
}

TEST(TemperatureRate, IsConstantInARampAndZeroInASoak) {
  const WholeRun result = run_text({"temperature_rate:coefficient=0.1"}, kOneRamp);
  const auto& rate = result.effect("temperature_rate");
  EXPECT_NEAR(mean(rate, kRampEnd - 360, kRampEnd), 0.05, 0.001);
  EXPECT_NEAR(mean(rate, kRampEnd + 1200, kRampEnd + 1440), 0, 0.0005);
}

TEST(TemperatureRate, FollowsFromTheStrainsWhereNoCoefficientIsGiven) {
  const WholeRun result = run_text({"temperature_rate"}, kOneRamp);
  EXPECT_NEAR(mean(result.effect("temperature_rate"), kRampEnd - 360, kRampEnd), 0.136 / 2, 0.003);
}

TEST(Shupe, SpikesAtBothEndsOfARampAndIsZeroBetween) {
  const WholeRun result = run_text({"shupe:peak=0.03"}, kOneRamp);
  const auto& shupe = result.effect("shupe");
  const double at_start = mean(shupe, kRampStart + 10, kRampStart + 60);
  const double between = mean(shupe, kRampEnd - 360, kRampEnd);
  const double at_end = mean(shupe, kRampEnd + 10, kRampEnd + 60);
  EXPECT_GT(std::abs(at_start), 0.01);
  EXPECT_NEAR(at_end, -at_start, 0.2 * std::abs(at_start));
  EXPECT_LT(std::abs(between), 0.02 * std::abs(at_start));
}

TEST(ThermalLag, GoesOnAfterTheRateTermHasEnded) {
  const WholeRun result = run_text(
      {"thermal_lag:coefficient=0.1,tau_s=1500", "temperature_rate:coefficient=0.1"}, kOneRamp);
  const auto& lagged = result.effect("thermal_lag");
  const auto& prompt = result.effect("temperature_rate");
  EXPECT_NEAR(mean(lagged, kRampEnd - 100, kRampEnd), 0.05, 0.002);
  EXPECT_GT(lagged[kRampEnd + 200], 1.5 * prompt[kRampEnd + 200]);
  EXPECT_LT(lagged[kRampStart + 60], 0.7 * prompt[kRampStart + 60]);
}

TEST(TemperatureRateProduct, ChangesSignWithTemperatureInAConstantRamp) {
  const WholeRun result =
      run_text({"temperature_rate_product"},
               "start -60 degC\nsoak 1 h\nramp to 100 degC at 0.5 degC/min\nsoak 1 h\n");
  const auto& product = result.effect("temperature_rate_product");
  for (std::size_t i = 360 + 600; i < 360 + 1800; ++i) {
    const double above_k = result.rows.coil_degc[i] - 20;
    if (std::abs(above_k) > 5) {
      ASSERT_GT(product[i] * above_k, 0) << "row " << i;
    }
  }
}

TEST(AxialGradient, ShowsWithAHeaterAndTheSecondSensor) {
  const WholeRun heated = whole_run(gyro_of({"axial_gradient"}), profile_of("heater_pulses"), {});
  EXPECT_GT(largest(heated.effect("axial_gradient")), 0.02);
  double difference_k = 0;
  for (std::size_t i = 0; i < heated.rows.rows(); ++i) {
    difference_k = std::max(
        difference_k, heated.rows[fog::Input::temperature2][i] - heated.rows.temperature_degc[i]);
  }
  EXPECT_GT(difference_k, 0.2);
}

TEST(PolarizationRipple, RepeatsInTemperatureNotInTime) {
  const WholeRun result =
      run_text({"polarization_ripple:amplitude_dph=0.01,period_k=10,second=0"},
               "start 0 degC\nsoak 1 h\nramp to 60 degC at 1 degC/min\nsoak 3 h\n"
               "ramp to 0 degC at 0.25 degC/min\nsoak 2 h\n");
  const auto& ripple = result.effect("polarization_ripple");
  const auto& degc = result.rows.coil_degc;
  // The same temperature met on the way up and, four times slower, on the way down.
  const auto up = std::find_if(degc.begin() + 360, degc.end(), [](double t) { return t > 30; });
  const auto down = std::find_if(degc.begin() + 2000, degc.end(), [](double t) { return t < 30; });
  EXPECT_NEAR(ripple[static_cast<std::size_t>(up - degc.begin())],
              ripple[static_cast<std::size_t>(down - degc.begin())], 0.002);
}

TEST(ThermalHysteresis, HasALoopOfItsWidthThatStaysInASoakAtAnyRate) {
  for (const std::string rate : {"0.5", "2"}) {
    const WholeRun result = run_text(
        {"thermal_hysteresis:width_dph=0.04"},
        "start 20 degC\nramp to 80 degC at " + rate + " degC/min\nsoak 2 h\nramp to 20 degC at " +
            rate + " degC/min\nsoak 6 h\nramp to -40 degC at " + rate +
            " degC/min\nsoak 2 h\nramp to 20 degC at " + rate + " degC/min\nsoak 6 h\n");
    const auto& loop = result.effect("thermal_hysteresis");
    const std::size_t last = loop.size() - 1;
    const auto after_hot =
        static_cast<std::size_t>((2 * 60 / std::stod(rate) * 60 + 8 * 3600 - 100) / 10);
    EXPECT_NEAR(loop[last] - loop[after_hot], 0.04, 0.002) << rate;
  }
}

TEST(GlassTransition, StepsAtItsTemperatureLaterInAFastRamp) {
  const auto crossing_degc = [](const std::string& rate) {
    const WholeRun result =
        run_text({"glass_transition:tg_degc=10,step_dph=0.03,rate_term=0"},
                 "start 60 degC\nsoak 3 h\nramp to -50 degC at " + rate + " degC/min\nsoak 3 h\n");
    const auto& bias = result.effect("glass_transition");
    EXPECT_LT(bias[1000], 0.001);
    EXPECT_NEAR(bias.back(), 0.03, 0.002);
    const auto half = std::find_if(bias.begin(), bias.end(), [](double b) { return b > 0.015; });
    return result.rows.coil_degc[static_cast<std::size_t>(half - bias.begin())];
  };
  const double slow_degc = crossing_degc("0.2");
  const double fast_degc = crossing_degc("3");
  EXPECT_NEAR(slow_degc, 10, 2.5);
  EXPECT_LT(fast_degc, slow_degc - 1);
}

TEST(WarmUp, ComesBackAfterAPowerCycleTheSmallerTheShorterTheBreak) {
  const WholeRun result = run_text({"warm_up:amplitude_dph=0.1,tau_s=600"},
                                   "soak 3 h\npower off\nsoak 3 h\npower on\nsoak 3 h\n"
                                   "power off\nsoak 5 min\npower on\nsoak 1 h\n");
  const auto& warm_up = result.effect("warm_up");
  const auto& time_s = result.rows.time_s;
  const auto at = [&](double t_s) {
    return warm_up[static_cast<std::size_t>(std::lower_bound(time_s.begin(), time_s.end(), t_s) -
                                            time_s.begin())];
  };
  EXPECT_NEAR(at(0), 0.1, 0.005);
  EXPECT_LT(at(10000), 1e-3);
  EXPECT_NEAR(at(6 * 3600), 0.1, 0.005);
  EXPECT_GT(at(9 * 3600 + 300), 0.02);
  EXPECT_LT(at(9 * 3600 + 300), 0.07);
}

TEST(PowerOff, LeavesAGapAndNoRowOfIt) {
  const WholeRun result = run_text({"bias"}, "soak 1 h\npower off\nsoak 1 h\npower on\nsoak 1 h\n");
  EXPECT_EQ(result.rows.rows(), 720U);
  EXPECT_EQ(result.rows.time_s[359], 3590);
  EXPECT_EQ(result.rows.time_s[360], 7200);
  EXPECT_EQ(result.rows.uptime_s[359], 3590);
  EXPECT_EQ(result.rows.uptime_s[360], 0);
}

TEST(Aging, OnlyGrowsAndIgnoresPowerCycles) {
  const WholeRun result =
      run_text({"aging"}, "soak 3 h\npower off\nsoak 3 h\npower on\nsoak 3 h\n");
  const auto& aging = result.effect("aging");
  EXPECT_TRUE(std::is_sorted(aging.begin(), aging.end()));
  EXPECT_GT(aging.back(), 0.005);
}

TEST(ScaleFactor, IsProportionalToTheInputRateAndReversesWithIt) {
  const WholeRun result =
      whole_run(gyro_of({"scale_factor_temperature:wavelength_ppm=100,coil_ppm=0"}),
                profile_of("rate_table"), coarse());
  const auto& error = result.effect("scale_factor_temperature");
  const auto& input = result.rows.input_rate_dph;
  std::size_t checked = 0;
  for (std::size_t i = 1; i + 1 < error.size(); ++i) {
    if (input[i] == 0) {
      EXPECT_EQ(error[i], 0);
    }
    if (input[i] == 36000 && input[i + 30] == -36000 && input[i + 29] == -36000) {
      EXPECT_NEAR(error[i], -error[i + 30], 0.1 * std::abs(error[i]));
      ++checked;
    }
  }
  EXPECT_GT(checked, 50U);
  EXPECT_NEAR(largest(error), 36000 * 100e-6 * 60, 0.25 * 36000 * 100e-6 * 60);
}

TEST(HalfWaveVoltage, IsCorrectedByTheSecondLoopExceptForItsLag) {
  SimulationOptions options = coarse();
  options.earth.latitude_deg = 90;
  const WholeRun result =
      run_text({"half_wave_voltage:half_wave_ppm=500,loop_tau_s=60,left=0"}, kOneRamp, options);
  const auto& error = result.effect("half_wave_voltage");
  // Tracking a ramp, a first-order loop is rate times time constant behind: 0.5 K.
  EXPECT_NEAR(mean(error, kRampEnd - 360, kRampEnd), 15.041 * 500e-6 * 0.5, 1e-4);
  EXPECT_NEAR(error.back(), 0, 2e-5);
}

TEST(DeadBand, HoldsZeroInsideAndLetsLargeRatesThrough) {
  const auto output = [](double rate_dph) {
    const WholeRun result = run_text({"bias:value_dph=" + std::to_string(rate_dph),
                                      "dead_band:half_width_dph=0.1,dither_dph=0.01"},
                                     "soak 10 min\n");
    return result.rows.rate_dph[10];
  };
  EXPECT_NEAR(output(0.05), 0, 0.001);
  EXPECT_NEAR(output(-0.05), 0, 0.001);
  EXPECT_NEAR(output(0.2), 0.2, 0.001);
  EXPECT_NEAR(output(-5), -5, 1e-9);
}

// Effects described by polynomials in the catalogue, to a few per cent of their size.
TEST(ScaleFactor, ErrorsHaveTheSizeThatTheyAreGiven) {
  constexpr double kFullScale_dph = 100 * 3600;
  const char* const sweeps = "soak 10 min\nsweep 100 deg/s every 100 s\nsoak 30 min\n";
  SimulationOptions options = coarse();
  options.rate_hz = 1;
  const WholeRun result = run_text(
      {"scale_factor:ppm=200", "scale_factor_nonlinearity:ppm=300,even_ppm=50,full_scale_dps=100",
       "scale_factor_asymmetry:ppm=20", "late_reference:delay_ms=30"},
      sweeps, options);
  for (std::size_t i = 700; i < result.rows.rows(); ++i) {
    const double u = result.rows.input_rate_dph[i] / kFullScale_dph;
    const double odd = 300 * (5 * u * u * u - 3 * u) / 2;
    const double even = 50 * 1.5 * u * u;
    EXPECT_NEAR(result.effect("scale_factor")[i], 200e-6 * u * kFullScale_dph, 0.1);
    EXPECT_NEAR(result.effect("scale_factor_nonlinearity")[i], 1e-6 * (odd + even) * kFullScale_dph,
                3);
    EXPECT_NEAR(result.effect("scale_factor_asymmetry")[i], 20e-6 * std::fabs(u) * kFullScale_dph,
                0.01 * 20e-6 * kFullScale_dph);
    const double change = 2 * M_PI / 100 * std::cos(2 * M_PI * (result.rows.time_s[i] - 600) / 100);
    EXPECT_NEAR(result.effect("late_reference")[i], 0.03 * change * kFullScale_dph, 25);
  }
}

TEST(BiasStep, StartsWhenToldAndDecays) {
  const WholeRun result =
      run_text({"bias_step:size_dph=0.1,first_s=1000,per_hour=0,tau_s=600"}, "soak 1 h\n");
  const auto& step = result.effect("bias_step");
  EXPECT_EQ(largest({step.begin(), step.begin() + 99}), 0);
  EXPECT_GT(std::abs(step[101]), 0.04);
  EXPECT_NEAR(step[161] / step[101], std::exp(-1), 0.01);
}

TEST(Surroundings, DriveMagneticVibrationAndLightPower) {
  const WholeRun field =
      whole_run(gyro_of({"magnetic:sensitivity=1e-3,temperature_slope=0", "vibration"}),
                profile_of("field_and_vibration"), coarse());
  const auto& magnetic = field.effect("magnetic");
  EXPECT_NEAR(mean(magnetic, 370, 470), 0.03, 1e-4);   // 30 uT of the Earth
  EXPECT_NEAR(mean(magnetic, 610, 700), -0.03, 1e-4);  // turned round
  EXPECT_NEAR(largest(field.effect("vibration")), 0.02 * 4, 0.005);
  const WholeRun light = whole_run(gyro_of({"light_power"}), profile_of("paper"), coarse());
  EXPECT_GT(largest(light.effect("light_power")), 0.001);
}

TEST(Pyroelectric, NeedsAFastChangeInTheCold) {
  const auto peak = [](const std::string& text) {
    return largest(run_text({"pyroelectric"}, text).effect("pyroelectric"));
  };
  EXPECT_GT(peak("start -40 degC\nsoak 1 h\nramp to 0 degC at 5 degC/min\nsoak 1 h\n"), 0.05);
  EXPECT_EQ(peak("start 20 degC\nsoak 1 h\nramp to 60 degC at 0.2 degC/min\nsoak 1 h\n"), 0);
}

TEST(RandomTelegraph, KnowsTwoLevelsAndKeepsEachForTheTimeAsked) {
  const auto levels = run_text({"random_telegraph:height_dph=0.02,dwell_s=600"}, "soak 100 h\n")
                          .effect("random_telegraph");
  std::size_t changes = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_TRUE(levels[i] >= -1e-12 && levels[i] < 0.02 + 1e-12);
    if ((levels[i] > 0.01) != (levels[i - 1] > 0.01)) ++changes;
  }
  EXPECT_NEAR(static_cast<double>(changes), 600, 100);  // 4 standard deviations
}

TEST(FastCycle, RepeatsInTimeWhateverTheTemperature) {
  const auto cycle = run_text({"fast_cycle:period_s=600"}, kOneRamp).effect("fast_cycle");
  for (std::size_t i = 60; i < cycle.size(); ++i) ASSERT_NEAR(cycle[i], cycle[i - 60], 1e-9);
  EXPECT_GT(largest(cycle), 0.009);
}

TEST(SquaredLag, CountsCoolingLikeWarmingAndComesLate) {
  const auto up = run_text({"squared_lag"}, kOneRamp).effect("squared_lag");
  EXPECT_NEAR(mean(up, kRampEnd - 60, kRampEnd), 0.1 * 0.25, 0.001);
  EXPECT_GT(up[kRampEnd + 90], 0.3 * up[kRampEnd]);
  const auto down = run_text({"squared_lag"},
                             "start 0 degC\nsoak 2 h\nramp to -90 degC at 0.5 "
                             "degC/min\n")
                        .effect("squared_lag");
  // In the meantime the electronics warm the coil, in either direction.
  EXPECT_NEAR(down[kRampStart + 600], up[kRampStart + 600], 5e-3 * up[kRampStart + 600]);
}

TEST(WarmestSoFar, MovesOnlyAtANewRecord) {
  const auto moved = run_text({"warmest_so_far"},
                              "start 20 degC\nramp to 0 degC at 1 degC/min\nsoak 2 h\n"
                              "ramp to 50 degC at 1 degC/min\nsoak 4 h\n"
                              "ramp to 20 degC at 1 degC/min\nsoak 2 h\n")
                         .effect("warmest_so_far");
  EXPECT_LT(moved[720], 1e-4);  // what the electronics warm the coil at the start
  EXPECT_NEAR(moved.back(), 0.03, 0.003);
  EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
}

TEST(MoistureExchange, LagsMoreInTheColdThanInTheWarm) {
  const std::vector<std::string> effect{"moisture_exchange:tau_s=3600,activation_ev=0.5"};
  const auto after_two_hours = [&](const char* degc) {
    return run_text(effect, std::string("start 20 degC\nramp to ") + degc +
                                " degC at 10 degC/min\nsoak 2 h\n")
        .effect("moisture_exchange")
        .back();
  };
  EXPECT_NEAR(after_two_hours("60"), 0.04, 0.002);  // the electronics warm it, too
  EXPECT_LT(after_two_hours("-20"), 0);
  EXPECT_GT(after_two_hours("-20"), -0.01);
}

TEST(RateNonlinearity, HasTheFormAskedForInALongRamp) {
  const auto at_ramp = [](const std::string& form) {
    const auto values =
        run_text({"rate_nonlinearity:form=" + form}, kOneRamp).effect("rate_nonlinearity");
    return std::pair(mean(values, kRampEnd - 360, kRampEnd),
                     mean(values, kRampEnd + 1200, kRampEnd + 1440));
  };
  EXPECT_NEAR(at_ramp("magnitude").first, 0.05 * 0.5, 0.0005);
  EXPECT_NEAR(at_ramp("square").first, 0.05 * 0.25, 0.0005);
  EXPECT_GT(at_ramp("temperature_squared").first, 0.05 * 0.5 * 1.0);
  for (const char* form : {"magnitude", "square", "temperature_squared"}) {
    EXPECT_NEAR(at_ramp(form).second, 0, 0.001) << form;
  }
}

}  // namespace
}  // namespace fogcomp::simulation
