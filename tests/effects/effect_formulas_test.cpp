// Every effect of the catalogue against its equation (host_tools/EFFECTS.md), implemented
// independently: in natural units, without the templates, constants and filters shared by board and
// fit. The histories have ramps, soaks, steps, sinusoidal temperature, restarts and a stretch
// beyond the trained range.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "support/typical_effects.hpp"

namespace {

using Values = std::vector<double>;

constexpr double kBlock_s = 0.1;  // short against every lag
constexpr double kDerivativeTau_s = 30;
constexpr double kMinDegc = -35;  // trained range
constexpr double kMaxDegc = 55;

// Measurements of a gyro, block by block.
struct History {
  std::string name;
  Values time_s;       // since power-on, at the end of the block
  Values at_end_degc;  // the coil's temperature at that moment
  Values mean_degc;    // and its mean over the block
  Values second_degc;  // second sensor, likewise
  Values second_mean_degc;
  Values input_rate_dph, magnetic_ut, light_power_uw, vibration_grms;
  std::vector<bool> starts;  // the thermal state begins anew: power-on, or a long gap

  std::size_t size() const { return time_s.size(); }
};

using Curve = std::function<double(double)>;

// Straight lines between points (time, value).
Curve polyline(std::vector<std::pair<double, double>> points) {
  return [points = std::move(points)](double t) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto [t0, y0] = points[i - 1];
      const auto [t1, y1] = points[i];
      if (t < t1) return t < t0 ? y0 : y0 + (y1 - y0) * (t - t0) / (t1 - t0);
    }
    return points.back().second;
  };
}

void add_stretch(History& history, const Curve& temperature, double from_s, double to_s) {
  const Curve second = [&](double t) { return temperature(t) + 3 * std::sin(t / 170) + 1; };
  for (long i = std::lround(from_s / kBlock_s); i <= std::lround(to_s / kBlock_s); ++i) {
    const double t = kBlock_s * static_cast<double>(i);
    history.starts.push_back(i == std::lround(from_s / kBlock_s));
    history.time_s.push_back(t);
    history.at_end_degc.push_back(temperature(t));
    history.mean_degc.push_back((temperature(t) + temperature(t - kBlock_s)) / 2);
    history.second_degc.push_back(second(t));
    history.second_mean_degc.push_back((second(t) + second(t - kBlock_s)) / 2);
    history.input_rate_dph.push_back(3e5 * std::sin(t / 400));
    history.magnetic_ut.push_back(60 * std::cos(t / 310));
    history.light_power_uw.push_back(80 * std::exp(0.5 * std::sin(t / 900)));
    history.vibration_grms.push_back(3 + 2 * std::sin(t / 250));
  }
}

std::vector<History> histories() {
  const Curve ramps = polyline({{300, 25}, {1500, -20}, {2400, -20}, {4200, 50}, {5000, 10}});
  const Curve steps =
      polyline({{300, 20}, {330, 32}, {1200, 32}, {1250, 12}, {2600, 12}, {2610, 14}});
  const Curve sinusoid = [](double t) {
    return 15 + 18 * std::sin(t / 350) + 2 * std::cos(t / 40);
  };
  const Curve beyond = polyline({{200, 40}, {1400, 75}, {2000, 75}, {4400, -50}, {5000, -20}});
  std::vector<History> all(4);
  all[0].name = "ramps and soaks";
  add_stretch(all[0], ramps, 0, 6000);
  all[1].name = "steps, and a restart at another temperature after a gap";
  add_stretch(all[1], steps, 0, 3000);
  add_stretch(all[1], polyline({{5200, -8}, {6400, 6}}), 5000, 7000);
  all[2].name = "sinusoidal temperature, recorded from an hour after power-on";
  add_stretch(all[2], sinusoid, 3600, 9000);
  all[3].name = "beyond the trained range";
  add_stretch(all[3], beyond, 0, 6000);
  return all;
}

// tau dy/dt = x - y by the trapezoidal rule; in equilibrium where the history starts.
Values first_order_lag(const History& history, const Values& x, double tau_s) {
  Values y(x.size());
  const double half = kBlock_s / tau_s / 2;
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] =
        history.starts[i] ? x[i] : (y[i - 1] * (1 - half) + half * (x[i] + x[i - 1])) / (1 + half);
  }
  return y;
}

// dx/dt after two lags, per minute: from the equation of the second lag.
Values rate_per_min(const History& history, const Values& x, double tau_s) {
  const Values once = first_order_lag(history, x, tau_s);
  const Values twice = first_order_lag(history, once, tau_s);
  Values rate(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) rate[i] = 60 * (once[i] - twice[i]) / tau_s;
  return rate;
}
Values rate_of(const History& history) {
  return rate_per_min(history, history.at_end_degc, kDerivativeTau_s);
}

// dTc/dt of a coil that follows the sensor with `tau_s`, per minute, after the same two lags.
Values coil_rate(const History& history, double tau_s) {
  const Values shown = first_order_lag(
      history, first_order_lag(history, history.at_end_degc, kDerivativeTau_s), kDerivativeTau_s);
  const Values coil = first_order_lag(history, shown, tau_s);
  Values rate(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) rate[i] = 60 * (shown[i] - coil[i]) / tau_s;
  return rate;
}

// T - 20 degC in the trained range.
Values above_20(const History& history) {
  Values above = history.mean_degc;
  for (double& t : above) t = std::min(std::max(t, kMinDegc), kMaxDegc) - 20;
  return above;
}

// Backlash of so many degC to either side: on the way up it is at least x - r, on the way down at
// most x + r. A gap does not change it.
Values play(const Values& x, double radius) {
  Values y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i == 0)
      y[i] = x[i];
    else if (x[i] >= x[i - 1])
      y[i] = std::max(y[i - 1], x[i] - radius);
    else
      y[i] = std::min(y[i - 1], x[i] + radius);
  }
  return y;
}

template <class Function>
Values map(const Values& x, const Function& function) {
  Values y = x;
  for (double& value : y) value = function(value);
  return y;
}
Values product(Values x, const Values& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= y[i];
  return x;
}
Values difference(Values x, const Values& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= y[i];
  return x;
}

// Contribution of an effect per natural unit of each of its coefficients.
using Columns = std::vector<Values>;

Columns ripple(const History& h, const Values& shape) {
  const double chirp = shape[2] / 100;
  const Values u = map(above_20(h), [&](double t) { return t * (1 + chirp * t); });
  Columns columns;
  for (const double period : {shape[0], shape[1]}) {
    if (period == 0) continue;
    columns.push_back(map(u, [&](double x) { return std::cos(2 * M_PI * x / period); }));
    columns.push_back(map(u, [&](double x) { return std::sin(2 * M_PI * x / period); }));
  }
  return columns;
}

Columns hysteresis(const History& h, const Values& radii) {
  const Values above = above_20(h);
  Columns columns;
  for (const double radius : radii) {
    if (radius == 0) continue;
    const Values behind = difference(above, play(above, radius));
    columns.push_back(map(behind, [&](double x) { return x / radius; }));
  }
  return columns;
}

Columns polynomial(const History& h, const Values& shape) {
  Columns columns;
  for (double k = 1; k <= shape[0]; ++k) {
    columns.push_back(map(above_20(h), [&](double t) { return std::pow(t, k); }));
  }
  return columns;
}

Columns glass(const History& h, const Values& shape) {
  const double tg_above_20 = shape[0] - 20;
  Values share = map(
      above_20(h), [&](double t) { return (1 + std::tanh((tg_above_20 - t) / shape[1] / 2)) / 2; });
  if (shape[2] > 0) share = first_order_lag(h, share, shape[2]);
  return {share, product(share, rate_of(h))};
}

Columns axial(const History& h, const Values& shape) {
  const Values at_end = difference(h.second_degc, h.at_end_degc);
  return {rate_per_min(h, at_end, shape[0]), difference(h.second_mean_degc, h.mean_degc)};
}

// The lag counts from the present block, the temperature is that of the block before.
Columns rate_and_temperature(const History& h, const Values& shape) {
  const double late_min = (shape[2] - kBlock_s) / 60;
  const Values change = map(rate_of(h), [&](double per_min) { return late_min * per_min; });
  const Values late = difference(above_20(h), change);
  const Values above = map(late, [&](double t) { return t + 20 - shape[1]; });
  Columns columns;
  for (double k = 1; k <= shape[0]; ++k) {
    const Values power = map(above, [&](double t) { return 1e-6 * std::pow(t, k); });
    columns.push_back(product(h.input_rate_dph, power));
  }
  return columns;
}

// Legendre's polynomials by their recursion, minus what they are at 0.
Columns nonlinearity(const History& h, const Values& shape) {
  const double full_scale = 3600 * shape[1];
  const auto legendre = [](double n, double u) {
    double before = 1;
    double now = u;
    for (double k = 1; k < n; ++k) {
      const double next = ((2 * k + 1) * u * now - k * before) / (k + 1);
      before = now;
      now = next;
    }
    return now;
  };
  Columns columns;
  for (double order = 2; order <= shape[0]; ++order) {
    columns.push_back(map(h.input_rate_dph, [&](double w) {
      const double u = std::min(std::max(w / full_scale, -1.0), 1.0);
      return 1e-6 * full_scale * (legendre(order, u) - legendre(order, 0));
    }));
  }
  return columns;
}

struct Formula {
  const char* effect;
  std::vector<Values> shapes;  // parameters, in the order of the catalogue
  Columns (*columns)(const History& h, const Values& shape);
};

// From `equation` in the header of each effect, and the unit of each coefficient. A new effect
// needs a formula here, an effect of one's own one in formulas.inc beside its header.
const std::vector<Formula> kFormulas{
#ifdef FOG_OWN_FORMULAS
#include FOG_OWN_FORMULAS
#endif
    {"bias", {{}}, [](const History& h, const Values&) { return Columns{Values(h.size(), 1)}; }},
    {"bias_temperature", {{1}, {2}, {9}}, polynomial},
    {"temperature_rate", {{}}, [](const History& h, const Values&) { return Columns{rate_of(h)}; }},
    {"shupe",
     {{60}, {2000}},
     [](const History& h, const Values& shape) {
       return Columns{difference(rate_of(h), coil_rate(h, shape[0]))};
     }},
    {"thermal_lag",
     {{60}, {2000}},
     [](const History& h, const Values& shape) { return Columns{coil_rate(h, shape[0])}; }},
    {"temperature_rate_product",
     {{}},
     [](const History& h, const Values&) { return Columns{product(above_20(h), rate_of(h))}; }},
    {"axial_gradient", {{20}, {300}}, axial},
    {"polarization_ripple", {{13, 0, 0}, {13, 4.8, 0.05}, {60, 5, -0.2}}, ripple},
    {"thermal_hysteresis", {{5, 0}, {3, 10}}, hysteresis},
    {"glass_transition", {{-20, 4, 0}, {25, 8, 0}, {-20, 4, 300}}, glass},
    {"scale_factor",
     {{}},
     [](const History& h, const Values&) {
       return Columns{map(h.input_rate_dph, [](double w) { return 1e-6 * w; })};
     }},
    {"scale_factor_temperature", {{1, 20, 0}, {1, 20, 90}, {3, -7.5, -240}}, rate_and_temperature},
    {"scale_factor_nonlinearity", {{2, 90}, {3, 60}, {5, 83.5}, {5, 500}}, nonlinearity},
    {"scale_factor_asymmetry",
     {{0.01}, {10}},
     [](const History& h, const Values& shape) {
       const double band = 3600 * shape[0];
       return Columns{map(h.input_rate_dph, [&](double w) {
         const double size = std::fabs(w);
         return 1e-6 * (size < band ? w * w / (2 * band) : size - band / 2);
       })};
     }},
    // The input rate of the histories is 3e5 deg/h sin(t / 400 s).
    {"late_reference",
     {{0}, {600}},
     [](const History& h, const Values& shape) {
       return Columns{map(h.time_s, [&](double t) {
         const double phase = (t - kBlock_s / 2) / 400;
         const double half_near_s = 1e-3 * shape[0] / 2;
         return 1e-3 * 3e5 / 400 * (std::cos(phase) - half_near_s / 400 * std::sin(phase));
       })};
     }},
    {"warm_up",
     {{300}, {9000}},
     [](const History& h, const Values& shape) {
       return Columns{map(h.time_s, [&](double t) { return std::exp(-t / shape[0]); })};
     }},
    {"aging",
     {{60, 1}, {50000, 1}, {2000, 1.3}},
     [](const History& h, const Values& shape) {
       const Values above = above_20(h);
       Values logarithm;
       double age_s = 0;
       double before_s = 0;
       for (std::size_t i = 0; i < h.size(); ++i) {
         age_s += std::pow(shape[1], above[i] / 10) * (h.time_s[i] - before_s);
         before_s = h.time_s[i];
         logarithm.push_back(std::log1p(age_s / shape[0]));
       }
       return Columns{logarithm};
     }},
    {"magnetic",
     {{}},
     [](const History& h, const Values&) {
       return Columns{h.magnetic_ut, product(h.magnetic_ut, above_20(h))};
     }},
    {"vibration",
     {{}},
     [](const History& h, const Values&) {
       return Columns{product(h.vibration_grms, h.vibration_grms)};
     }},
    {"light_power",
     {{}},
     [](const History& h, const Values&) {
       return Columns{map(h.light_power_uw, [](double p) { return std::log(p / 100); })};
     }},
    {"bias_step",
     {{2500}, {5600}},
     [](const History& h, const Values& shape) {
       return Columns{map(h.time_s, [&](double t) { return t >= shape[0] ? 1.0 : 0.0; })};
     }},
};

fogcomp::model::RealBlock block_of(const History& history, std::size_t i) {
  fogcomp::model::RealBlock block;
  block.temperature = history.mean_degc[i];
  block.input_rate = history.input_rate_dph[i];
  const double t = history.time_s[i];
  block.rate_within.rise = 3e5 * (std::sin(t / 400) - std::sin((t - kBlock_s) / 400));
  block.rate_within.rise_of_slope =
      3e5 / 400 * (std::cos(t / 400) - std::cos((t - kBlock_s) / 400));
  block.elapsed = history.time_s[i] / kBlock_s;
  const auto set = [&](fog::Input input, double value) { block[input] = value; };
  set(fog::Input::temperature2, history.second_mean_degc[i]);
  set(fog::Input::magnetic, history.magnetic_ut[i]);
  set(fog::Input::light_power, history.light_power_uw[i]);
  set(fog::Input::vibration, history.vibration_grms[i]);
  return block;
}

// The same from the effect itself, as board and fit run it, and the units that it states.
Columns columns_of(const fogcomp::model::CatalogueEntry& entry, const Values& shape,
                   const History& history) {
  fogcomp::model::Model model;
  model.derivative_tau_s = kDerivativeTau_s;
  model.min_degc = kMinDegc;
  model.max_degc = kMaxDegc;
  fog::ThermalState<fogcomp::model::RealNumbers> thermal(
      fogcomp::model::thermal_parameters(model, kBlock_s));
  fogcomp::model::RegressorBank bank({fog::test::natural_term(entry.description.name, shape, {})},
                                     kBlock_s);
  Columns columns(bank.size(), Values(history.size()));
  for (std::size_t i = 0; i < history.size(); ++i) {
    const fogcomp::model::RealBlock block = block_of(history, i);
    const auto signals = history.starts[i] ? thermal.reset(block) : thermal.step(block);
    if (history.starts[i]) bank.reset(signals);
    const Values& regressors = bank.step(signals);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      columns[column][i] =
          regressors[column] / fogcomp::model::in_natural_unit(1, entry.coefficients[column]);
    }
  }
  return columns;
}

double max_abs(const Values& values) {
  double max = 0;
  for (const double value : values) max = std::max(max, std::abs(value));
  return max;
}

TEST(EffectFormulas, ThereIsOneForEveryEffectOfTheCatalogue) {
  std::vector<std::string> known;
  for (const Formula& formula : kFormulas) known.emplace_back(formula.effect);
  const std::vector<std::string> effects = fogcomp::model::effect_names();
  for (const std::string& effect : effects) {
    EXPECT_EQ(std::count(known.begin(), known.end(), effect), 1)
        << effect << " has no equation of its own: an entry of kFormulas here, or of formulas.inc "
        << "beside the header of your own effects (firmware/core/effects/TUTORIAL.md, 2).";
  }
  EXPECT_EQ(known.size(), effects.size());
}

// Within 0.2 % of the largest value: a derivative over a block is half a block late, of lags of 20
// s and more.
TEST(EffectFormulas, AreWhatBoardAndFitCompute) {
  const std::vector<History> all = histories();
  for (const Formula& formula : kFormulas) {
    const fogcomp::model::CatalogueEntry& entry = fogcomp::model::find_effect(formula.effect);
    ASSERT_FALSE(formula.shapes.empty()) << formula.effect;
    for (const Values& shape : formula.shapes) {
      Values largest(entry.coefficients.size());
      for (const History& history : all) {
        const Columns expected = formula.columns(history, shape);
        const Columns got = columns_of(entry, shape, history);
        ASSERT_EQ(got.size(), expected.size()) << formula.effect << testing::PrintToString(shape);
        for (std::size_t i = 0; i < expected.size(); ++i) {
          largest[i] = std::max(largest[i], max_abs(expected[i]));
          EXPECT_LE(max_abs(difference(got[i], expected[i])), 2e-3 * max_abs(expected[i]))
              << formula.effect << testing::PrintToString(shape) << ", "
              << entry.coefficients[i].symbol << ": " << history.name;
        }
        largest.resize(expected.size());
      }
      const double smallest = *std::min_element(largest.begin(), largest.end());
      EXPECT_GT(smallest, 0) << "no history shows all of " << formula.effect;
    }
  }
}

}  // namespace
