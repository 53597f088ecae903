#include "diagnosis/forms.hpp"

#include <cmath>
#include <string>
#include <string_view>

#include "model/effect_list.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

// Bounds of a lag: from barely visible in a row to still visible in a programme of hours.
const std::string kLagBounds = "?tau[20,6000]";
// A zero that is further from the range than so many times its width is no special value: the
// square and the cube of such a signal are straight lines on these rows.
constexpr double kFarZero = 2;
// Distance of a kink from the ends of the range.
constexpr double kKinkMargin = 0.1;
// Period of a sine, in units of the range: shorter ones are lost in noise, longer ones look like a
// square.
constexpr double kMinPeriod = 0.1;
constexpr double kMaxPeriod = 2;

constexpr std::string_view kDegC = "degC";

class Formulas {
 public:
  void add(const std::string& name, const std::string& text) {
    model::add_expression(terms_, name + " = " + text);
  }
  std::vector<model::EffectTerm> take() { return std::move(terms_); }

 private:
  std::vector<model::EffectTerm> terms_;
};

struct VaryingSignal {
  std::string symbol;
  model::SignalRange range;
  bool has_zero;  ///< 0 degC is no special temperature
  bool is_extension;

  double span() const { return range.max - range.min; }
  /// The signal, counted from the middle of its range if its zero is far away.
  std::string text() const {
    const double middle = (range.min + range.max) / 2;
    if (!is_extension || std::abs(middle) < kFarZero * span()) return symbol;
    return format("(%s%+.4g)", symbol.c_str(), -middle);
  }
  /// Placeholder of a value to be fitted.
  std::string somewhere() const {
    const double margin = kKinkMargin * span();
    return format("?c[%.6g,%.6g]", range.min + margin, range.max - margin);
  }
};

std::vector<VaryingSignal> varying_signals(const series::SignalSeries& series,
                                           fog::InputMask inputs) {
  const model::SignalRanges ranges = series.signal_ranges();
  std::vector<VaryingSignal> signals;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (input.input == fog::Input::elapsed || !has(inputs, input.input)) continue;
    const model::SignalRange& range = ranges[static_cast<std::size_t>(input.input)];
    if (range.max <= range.min) continue;
    signals.push_back({input.symbol, range, input.unit != kDegC, fog::is_extension(input.input)});
  }
  return signals;
}

std::string lag_text(const std::string& text) {
  return "lag(" + text + "," + kLagBounds + ")";
}
// Through two masses in a chain, such as housing and coil: no single lag begins as slowly.
std::string twice_lag_text(const std::string& text) {
  return "lag(" + lag_text(text) + ",?tau)";
}

// Forms of one signal. Not for what the catalogue has: powers of the temperature
// (bias_temperature), periods in it (polarization_ripple), its rate with a lag (thermal_lag). A
// polynomial of a part that is warmed late is bias_temperature, thermal_lag and powers of the late
// temperature.
void add_own_forms(Formulas& formulas, const VaryingSignal& signal) {
  const std::string& name = signal.symbol;
  const std::string x = signal.text();
  const model::SignalRange& range = signal.range;
  const double span = signal.span();
  formulas.add(name + "_late_squared", lag_text(x) + "^2");
  if (x == "T") formulas.add("T_late_cubed", lag_text(x) + "^3");
  if (x == "dTdt") {
    formulas.add("dTdt_twice_late_squared", twice_lag_text(x) + "^2");
    formulas.add("dTdt_twice_late_size", "abs(" + twice_lag_text(x) + ")");
  }
  if (x != "T") {
    if (signal.is_extension) formulas.add(name + "_itself", name);
    formulas.add(name + "_squared", x + "^2");
    formulas.add(name + "_cubed", x + "^3");
    formulas.add(name + "_squared_late", lag_text(x + "^2"));
    if (range.min < 0 && range.max > 0) {
      formulas.add(name + "_size", "abs(" + x + ")");
      formulas.add(name + "_size_late", lag_text("abs(" + x + ")"));
      formulas.add(name + "_late_size", "abs(" + lag_text(x) + ")");
      formulas.add(name + "_signed_square", x + "*abs(" + x + ")");
    }
    if (x != "dTdt") formulas.add(name + "_late", lag_text(x));
    formulas.add(name + "_sine", format("sin(6.2832*%s/?p[%.4g,%.4g])", x.c_str(),
                                        kMinPeriod * span, kMaxPeriod * span));
  }
  formulas.add(name + "_kink", "max(" + name + "-" + signal.somewhere() + ",0)");
}

// Products of two signals, of at most three factors. T*dTdt is temperature_rate_product.
void add_products(Formulas& formulas, const VaryingSignal& a, const VaryingSignal& b) {
  const std::string name = a.symbol + "_";
  const std::string x = a.text();
  const std::string y = b.text();
  const std::string& other = b.symbol;
  if (x != "T" || y != "dTdt") formulas.add(name + other, x + "*" + y);
  formulas.add(name + "squared_" + other, x + "^2*" + y);
  formulas.add(name + other + "_squared", x + "*" + y + "^2");
  if (!a.has_zero) {
    const std::string about = "(" + a.symbol + "-" + a.somewhere() + ")";
    formulas.add(name + "offset_squared_" + other, about + "^2*" + y);
    formulas.add(name + "offset_" + other + "_squared", about + "*" + y + "^2");
  }
  if (b.range.min < 0 && b.range.max > 0) {
    formulas.add(name + other + "_size", x + "*abs(" + y + ")");
  }
  formulas.add(name + other + "_late", lag_text(x + "*" + y));
}

}  // namespace

std::vector<model::EffectTerm> formulas_over(const series::SignalSeries& series,
                                             fog::InputMask inputs) {
  const std::vector<VaryingSignal> signals = varying_signals(series, inputs);
  Formulas formulas;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    add_own_forms(formulas, signals[i]);
    for (std::size_t j = i + 1; j < signals.size(); ++j) {
      add_products(formulas, signals[i], signals[j]);
    }
  }
  return formulas.take();
}

std::string form_text(const model::Expression& expression) {
  std::string text;
  bool in_bounds = false;
  for (const char letter : expression.text) {
    if (letter == '[') in_bounds = true;
    if (!in_bounds && letter != '?') text += letter;
    if (letter == ']') in_bounds = false;
  }
  return text;
}

}  // namespace fogcomp::diagnosis
