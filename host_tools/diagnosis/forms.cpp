#include "diagnosis/forms.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "diagnosis/decision_rules.hpp"
#include "fit/expression_survey.hpp"
#include "fit/reference_values.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/shape_parameter.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

const std::string kLagBounds = format("?tau[%g,%g]", kShortestLag_s, kLongestLag_s);
// A zero that is further from the range than so many times its width is no special value: the
// square and the cube of such a signal are straight lines on these rows.
constexpr double kFarZero = 2;
// Distance of a kink from the ends of the range.
constexpr double kKinkMargin = 0.1;
// Period of a sine, in units of the range: shorter ones are lost in noise, longer ones look like a
// square.
constexpr double kMinPeriod = 0.1;
constexpr double kMaxPeriod = 2;

// Half a turn, as a coefficient has either sign. The two phases that the search begins with are a
// quarter of a turn apart.
const std::string kPhaseBounds = "?c[-2,2]";

constexpr std::string_view kDegC = "degC";

struct VaryingSignal {
  std::string symbol;
  model::SignalRange range;
  bool has_zero;  ///< 0 degC is no special temperature
  bool is_extension;

  double span() const { return range.max - range.min; }
  bool has_both_signs() const { return range.min < 0 && range.max > 0; }
  /// The signal, counted from the middle of its range if its zero is far away.
  std::string text() const {
    const double middle = (range.min + range.max) / 2;
    if (!is_extension || std::abs(middle) < kFarZero * span()) return symbol;
    return format("(%s%+.4g)", symbol.c_str(), -middle);
  }
  double margin() const { return kKinkMargin * span(); }
  /// Placeholder of a value to be fitted, above a value of the signal.
  std::string above(double value) const {
    return format("?c[%.6g,%.6g]", value + margin(), range.max - margin());
  }
  std::string somewhere() const { return above(range.min); }
};

class Formulas {
 public:
  void add(FormMeaning meaning, const std::string& name, const std::string& text) {
    model::add_expression(terms_, name + " = " + text);
    meanings_.push_back(meaning);
  }
  // Forms of one signal. Not for what the catalogue has: powers of the temperature
  // (bias_temperature), periods in it (polarization_ripple), its rate with a lag (thermal_lag). A
  // polynomial of a part that is warmed late is bias_temperature, thermal_lag and powers of the
  // late temperature.
  void add_own(const VaryingSignal& signal);
  // What the first heat of a coil leaves, from its temperature at the beginning on or from a higher
  // one that it had known before.
  void add_first_heat(const VaryingSignal& temperature, const series::Rows& rows);
  // Products of two signals, of at most three factors. T*dTdt is temperature_rate_product.
  void add_products(const VaryingSignal& a, const VaryingSignal& b);
  std::vector<Formula> take() {
    std::vector<Formula> formulas;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      formulas.push_back({std::move(terms_[i]), meanings_[i]});
    }
    return formulas;
  }

 private:
  void add_late(const VaryingSignal& signal);

  std::vector<model::EffectTerm> terms_;
  std::vector<FormMeaning> meanings_;  // of each term
};

// A temperature within the noise or a step of its thermometer is steady, and so is its rate.
std::vector<VaryingSignal> varying_signals(const series::SignalSeries& series,
                                           fog::InputMask inputs) {
  const model::SignalRanges ranges = series.signal_ranges();
  const series::Thermometer& thermometer = series.thermometer();
  const model::SignalRange& degc = ranges[static_cast<std::size_t>(fog::Input::temperature)];
  if (degc.max - degc.min <= std::max(thermometer.resolution_degc, thermometer.noise_degc)) {
    inputs &= ~(bit_of(fog::Input::temperature) | bit_of(fog::Input::temperature_rate));
  }
  std::vector<VaryingSignal> signals;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (input.input == fog::Input::elapsed || !has(inputs, input.input)) continue;
    const model::SignalRange& range = ranges[static_cast<std::size_t>(input.input)];
    if (range.max <= range.min) continue;
    signals.push_back({input.symbol, range, input.unit != kDegC, fog::is_extension(input.input)});
  }
  return signals;
}

std::string period_text(double span) {
  return format("?p[%.4g,%.4g]", kMinPeriod * span, kMaxPeriod * span);
}
std::string lag_text(const std::string& text) {
  return "lag(" + text + "," + kLagBounds + ")";
}
// Through two masses in a chain, such as housing and coil: no single lag begins as slowly.
std::string twice_lag_text(const std::string& text) {
  return "lag(" + lag_text(text) + ",?tau)";
}

// What powers and magnitudes of a signal mean.
FormMeaning meaning_of_curve(const VaryingSignal& signal, FormMeaning of_rate) {
  if (signal.symbol == "dTdt") return of_rate;
  return signal.symbol == "W" ? FormMeaning::scale_factor : FormMeaning::bent_input;
}

void Formulas::add_late(const VaryingSignal& signal) {
  const std::string& name = signal.symbol;
  const std::string x = signal.text();
  add(FormMeaning::late, name + "_late_squared", lag_text(x) + "^2");
  if (x == "T") add(FormMeaning::late, "T_late_cubed", lag_text(x) + "^3");
  if (x == "dTdt") {
    add(FormMeaning::twice_late, "dTdt_twice_late_squared", twice_lag_text(x) + "^2");
    add(FormMeaning::twice_late, "dTdt_twice_late_size", "abs(" + twice_lag_text(x) + ")");
  }
  if (x == "T") return;
  add(FormMeaning::late, name + "_squared_late", lag_text(x + "^2"));
  if (signal.has_both_signs()) {
    add(FormMeaning::late, name + "_size_late", lag_text("abs(" + x + ")"));
    add(FormMeaning::late, name + "_late_size", "abs(" + lag_text(x) + ")");
  }
  if (x != "dTdt") add(FormMeaning::late, name + "_late", lag_text(x));
}

void Formulas::add_own(const VaryingSignal& signal) {
  const std::string& name = signal.symbol;
  const std::string x = signal.text();
  add_late(signal);
  if (x != "T") {
    if (signal.is_extension) add(FormMeaning::input, name + "_itself", name);
    add(meaning_of_curve(signal, FormMeaning::squared_rate), name + "_squared", x + "^2");
    add(meaning_of_curve(signal, FormMeaning::bent_rate), name + "_cubed", x + "^3");
    if (signal.has_both_signs()) {
      const FormMeaning sizes = meaning_of_curve(signal, FormMeaning::one_direction);
      add(sizes, name + "_size", "abs(" + x + ")");
      add(sizes, name + "_signed_square", x + "*abs(" + x + ")");
    }
    add(FormMeaning::interference, name + "_sine",
        format("sin(6.2832*%s/%s)", x.c_str(), period_text(signal.span()).c_str()));
  }
  const FormMeaning kink = x == "dTdt"   ? FormMeaning::one_direction
                           : name == "W" ? FormMeaning::scale_factor
                                         : FormMeaning::onset;
  add(kink, name + "_kink", "max(" + name + "-" + signal.somewhere() + ",0)");
}

void Formulas::add_first_heat(const VaryingSignal& temperature, const series::Rows& rows) {
  double begin_degc = temperature.range.max;
  for (const std::size_t row : rows.run_starts) {
    begin_degc = std::min(begin_degc, rows.inputs[row].temperature);
  }
  if (begin_degc + 2 * temperature.margin() >= temperature.range.max) return;
  add(FormMeaning::first_heat, "T_highest", "highest(T)");
  add(FormMeaning::first_heat, "T_highest_kink",
      "max(highest(T)-" + temperature.above(begin_degc) + ",0)");
}

// What a product of three factors means that is linear in `b`, or in `a`.
struct ProductMeanings {
  FormMeaning linear_in_b = FormMeaning::product;
  FormMeaning linear_in_a = FormMeaning::product;
  FormMeaning size = FormMeaning::product;
};
ProductMeanings meanings_of(const VaryingSignal& a, const VaryingSignal& b) {
  const bool is_rate = a.symbol == "T" && b.symbol == "dTdt";
  return is_rate ? ProductMeanings{FormMeaning::bent_rate, FormMeaning::squared_rate,
                                   FormMeaning::one_direction}
                 : ProductMeanings{};
}

void Formulas::add_products(const VaryingSignal& a, const VaryingSignal& b) {
  const std::string name = a.symbol + "_";
  const std::string x = a.text();
  const std::string y = b.text();
  const std::string& other = b.symbol;
  const ProductMeanings meanings = meanings_of(a, b);
  const bool is_late_scale_factor = a.symbol == "dTdt" && other == "W";
  if (x != "T" || y != "dTdt") {
    add(is_late_scale_factor ? FormMeaning::late_scale_factor : FormMeaning::product, name + other,
        x + "*" + y);
  }
  add(meanings.linear_in_b, name + "squared_" + other, x + "^2*" + y);
  if (x == "T") {
    add(FormMeaning::interference, "T_sine_" + other,
        format("sin(6.2832*T/%s+%s)*", period_text(a.span()).c_str(), kPhaseBounds.c_str()) + y);
  }
  add(meanings.linear_in_a, name + other + "_squared", x + "*" + y + "^2");
  if (!a.has_zero) {
    const std::string about = "(" + a.symbol + "-" + a.somewhere() + ")";
    add(meanings.linear_in_b, name + "offset_squared_" + other, about + "^2*" + y);
    add(meanings.linear_in_a, name + "offset_" + other + "_squared", about + "*" + y + "^2");
    // Without the magnitude the catalogue has those of the rates.
    if (b.is_extension) add(meanings.linear_in_b, name + "offset_" + other, about + "*" + y);
    if (b.has_both_signs()) {
      add(meanings.size, name + "offset_" + other + "_size", about + "*abs(" + y + ")");
    }
  }
  if (b.has_both_signs()) {
    add(meanings.size, name + other + "_size", x + "*abs(" + y + ")");
  }
  add(FormMeaning::late, name + other + "_late", lag_text(x + "*" + y));
}

// The spans on these rows of the catalogue's effects that have one shape, each with a constant.
std::vector<Eigen::MatrixXd> spans_of_catalogue(const series::SignalSeries& series,
                                                fog::InputMask inputs) {
  std::vector<Eigen::MatrixXd> spans;
  for (const model::CatalogueEntry& entry : model::catalogue()) {
    if (entry.description.event || (entry.description.needs & ~inputs) != 0) continue;
    std::vector<model::EffectTerm> terms = model::parse_effects(entry.description.name);
    if (!model::shape_parameters(terms).empty()) continue;
    fit::set_references(terms, series);
    const Eigen::MatrixXd columns = series.regressors(terms[0]);
    const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(columns.rows(), 1);
    spans.push_back(orthonormal(side_by_side({constant, columns}, columns.rows())));
  }
  return spans;
}

// A formula that an effect of the catalogue contains is that effect, and no rival of its name.
std::vector<Formula> without_those_of_catalogue(std::vector<Formula> formulas,
                                                const series::SignalSeries& series,
                                                fog::InputMask inputs) {
  const std::vector<Eigen::MatrixXd> spans = spans_of_catalogue(series, inputs);
  const auto is_known = [&](const Formula& formula) {
    std::vector<model::EffectTerm> terms{formula.term};
    if (!model::shape_parameters(terms).empty()) return false;
    fit::set_expression_ranges(terms, series);
    const Eigen::MatrixXd column = series.regressors(terms[0]);
    const double size = (column.array() - column.mean()).matrix().norm();
    return std::any_of(spans.begin(), spans.end(), [&](const Eigen::MatrixXd& span) {
      return projected_out(span, column).norm() < rules::kMinVisible * size;
    });
  };
  formulas.erase(std::remove_if(formulas.begin(), formulas.end(), is_known), formulas.end());
  return formulas;
}

}  // namespace

std::vector<Formula> formulas_over(const series::SignalSeries& series, fog::InputMask inputs) {
  const std::vector<VaryingSignal> signals = varying_signals(series, inputs);
  Formulas formulas;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    formulas.add_own(signals[i]);
    if (signals[i].symbol == "T") formulas.add_first_heat(signals[i], series.rows());
    if (signals[i].symbol == "W" && has(inputs, fog::Input::elapsed)) {
      formulas.add(FormMeaning::late_scale_factor, "W_warming_up", "W*exp(-t/" + kLagBounds + ")");
    }
    for (std::size_t j = i + 1; j < signals.size(); ++j) {
      formulas.add_products(signals[i], signals[j]);
    }
  }
  return without_those_of_catalogue(formulas.take(), series, inputs);
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
