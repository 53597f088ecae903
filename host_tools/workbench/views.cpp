#include "workbench/views.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "compare/dependence.hpp"
#include "diagnosis/structure.hpp"
#include "findings/compare_words.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"
#include "report/plots.hpp"
#include "support/text.hpp"

namespace fogcomp::workbench {
namespace {

std::string unit_of(const std::string& unit) {
  return findings::words(unit).typeset();
}

Json parameters_json(const model::EffectTerm& term, const model::TermInfo& info) {
  Json parameters = Json::array();
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const model::TermInfo::Parameter& parameter = info.parameters[i];
    Json one = Json::object();
    one.set("name", parameter.name).set("unit", unit_of(parameter.unit));
    const model::Parameter& own = term.parameters[i];
    const model::Estimate value = model::shape_value(term, i);
    one.set("value", value.value).set("sigma", value.sigma);
    one.set("identified", own.identified).set("left_out", own.is_left_at_zero());
    one.set("min", parameter.bounds.min).set("max", parameter.bounds.max);
    one.set("whole", parameter.scale == fog::Scale::whole);
    one.set("logarithmic", parameter.scale == fog::Scale::logarithmic);
    parameters.push(std::move(one));
  }
  return parameters;
}

// The term as an argument of `fit --effects`: its name, the shape parameters that are fixed
// (=value), and those identified that by default are not (=?).
std::string effect_words(const model::EffectTerm& term) {
  if (term.expression) return term.name + " = " + term.expression->expression.text;
  std::string words = term.name;
  const model::CatalogueEntry& entry = model::find_effect(term.name);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const fog::ParameterDescription& parameter = entry.parameters[i];
    if (model::is_reference(parameter)) continue;
    const bool by_itself = parameter.not_given == fog::NotGiven::identified;
    const double value = term.parameters[i].value;
    const bool is_default = value == parameter.default_milli / 1000.0;
    if (term.parameters[i].identified) {
      if (!by_itself) words += std::string(":") + parameter.name + "=?";
    } else if (by_itself || !is_default) {
      words += std::string(":") + parameter.name + "=" + Json(value).text();
    }
  }
  return words;
}

Json coefficients_json(const model::EffectTerm& term, const model::TermInfo& info) {
  Json coefficients = Json::array();
  for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
    const fog::CoefficientDescription& description = info.coefficients[i];
    const model::Estimate coefficient = model::natural_coefficient(term, i);
    coefficients.push(Json::object()
                          .set("symbol", description.symbol)
                          .set("unit", unit_of(description.unit))
                          .set("value", coefficient.value)
                          .set("sigma", coefficient.sigma));
  }
  return coefficients;
}

Json terms_json(const model::Model& model) {
  return json_array(model.terms, [](const model::EffectTerm& term) {
    const model::TermInfo info = model::info_of(term);
    Json one = Json::object();
    one.set("effect", term.name);
    one.set("words", effect_words(term)).set("is_expression", term.expression.has_value());
    one.set("parameters", parameters_json(term, info));
    one.set("coefficients", coefficients_json(term, info));
    one.set("doubt", findings::words(model::coefficient_doubt(term)).sentence());
    return one;
  });
}

// Correlations of what the fit has found, in the order of the model's terms; null if there is none.
Json correlations_json(const model::Model& model) {
  if (!model.uncertainty) return {};
  Json names = Json::array();
  std::vector<model::EffectTerm> terms;
  for (const model::EffectTerm& term : model.terms) {
    if (model::is_found_event(term)) continue;
    terms.push_back(term);
    for (const fog::CoefficientDescription& coefficient : model::info_of(term).coefficients)
      names.push(term.name + " " + coefficient.symbol);
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(terms)) {
    const model::EffectTerm& term = terms[shape.term];
    names.push(term.name + " " + model::info_of(term).parameters[shape.index].name);
  }
  const Eigen::MatrixXd& covariance = model.uncertainty->covariance;
  const Eigen::VectorXd variance = covariance.diagonal().cwiseMax(1e-150);
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    const Eigen::VectorXd row =
        covariance.row(i).transpose().array() / (variance[i] * variance.array()).sqrt();
    rows.push(Json(std::vector<double>(row.begin(), row.end())));
  }
  return Json::object().set("names", std::move(names)).set("rows", std::move(rows));
}

// The history as a call in an expression: "lag(T, 300 s)".
std::string name_of(const diagnosis::TemperatureHistory& history) {
  return history.is_play ? format("play(T, %g degC)", history.parameter)
                         : format("lag(T, %g s)", history.parameter);
}

constexpr const char* kRateProduct = "temperature_degc x temperature_rate";

// Columns that the residual can be drawn over, with the labels of their axes.
Json variables_json(const compare::Comparison& comparison) {
  Json variables = Json::array();
  const auto push = [&](const std::string& name, const findings::Text& label) {
    variables.push(Json::object().set("name", name).set("label", label.typeset()));
  };
  push("temperature_degc", findings::words("temperature, degC"));
  push("temperature_rate", findings::words("temperature rate, degC/min"));
  push(kRateProduct, findings::words("temperature x temperature rate, degC^2/min"));
  push("time_s", findings::words("time since power-on, s"));
  for (const compare::Comparison::VaryingInput& input : comparison.inputs) {
    push(description_of(input.input).name, findings::input_label(input.input));
  }
  for (const diagnosis::TemperatureHistory& history : diagnosis::kTemperatureHistories) {
    push(name_of(history),
         findings::words("history: temperature less " + name_of(history) + ", degC"));
  }
  push("measured_dph", findings::words("rate less input rate, deg/h"));
  push("modelled_dph", findings::words("modelled drift, deg/h"));
  return variables;
}

// The sentences of `compare` on a run.
Json words_json(const compare::ModelOnRun& run, const model::Model& model) {
  std::vector<std::string> words{findings::error_words(run.comparison),
                                 findings::structure_words(run)};
  for (const std::string& remark : findings::remarks(run)) words.push_back(remark);
  for (const std::string& warning : findings::range_warnings(run.comparison, model)) {
    words.push_back(warning);
  }
  words.erase(std::remove(words.begin(), words.end(), ""), words.end());
  return json_array(words,
                    [](const std::string& text) { return findings::words(text).sentence(); });
}

std::vector<double> numbers_of(const std::vector<compare::Branch>& branches) {
  std::vector<double> numbers;
  for (const compare::Branch branch : branches) numbers.push_back(static_cast<double>(branch));
  return numbers;
}

// 1 for each row after a gap and for the first, else 0.
std::vector<double> gaps_of(const series::Rows& rows) {
  std::vector<double> gaps(rows.time_s.size());
  for (const recording::RowRange& stretch : rows.stretches()) gaps[stretch.first] = 1;
  return gaps;
}

}  // namespace

Json model_json(const model::Model& model) {
  Json json = Json::object();
  json.set("text", model::model_text(model)).set("terms", terms_json(model));
  json.set("correlations", correlations_json(model));
  json.set("residual_rms_dph", model.residual_rms_dph);
  json.set("average_s", model.average_s).set("derivative_tau_s", model.derivative_tau_s);
  return json;
}

Json run_json(const compare::ModelOnRun& run, const model::Model& model) {
  return Json::object()
      .set("file", run.comparison.file)
      .set("words", words_json(run, model))
      .set("bands", report::bands_json(findings::bands_of(
                        {run.comparison.segments.begin(), run.comparison.segments.end()})))
      .set("variables", variables_json(run.comparison));
}

Columns columns_of(const compare::Comparison& comparison) {
  Columns columns;
  columns["time_s"] = comparison.rows.time_s;
  columns["temperature_degc"] = comparison.rows.temperatures_degc();
  columns["temperature_rate"] = comparison.rows.temperature_rates_degc_per_min();
  std::transform(columns["temperature_degc"].begin(), columns["temperature_degc"].end(),
                 columns["temperature_rate"].begin(), std::back_inserter(columns[kRateProduct]),
                 std::multiplies<>());
  columns["measured_dph"] = comparison.measured_dph();
  columns["modelled_dph"] = {comparison.modelled_dph.begin(), comparison.modelled_dph.end()};
  columns["residual_dph"] = comparison.residuals_dph();
  columns["outlier"] = {comparison.outlier.begin(), comparison.outlier.end()};
  columns["branch"] = numbers_of(compare::branches(columns["temperature_degc"]));
  columns["gap_before"] = gaps_of(comparison.rows);
  for (const compare::Comparison::VaryingInput& input : comparison.inputs) {
    columns[description_of(input.input).name] = input.values;
  }
  const Eigen::VectorXd temperature =
      Eigen::Map<const Eigen::VectorXd>(columns["temperature_degc"].data(), comparison.rows.size());
  for (const diagnosis::TemperatureHistory& history : diagnosis::kTemperatureHistories) {
    const Eigen::VectorXd beyond =
        diagnosis::temperature_beyond(comparison.rows, temperature, history);
    columns[name_of(history)] = {beyond.begin(), beyond.end()};
  }
  return columns;
}

}  // namespace fogcomp::workbench
