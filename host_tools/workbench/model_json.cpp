#include "workbench/model_json.hpp"

#include "findings/text.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"

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

Json history_json(const std::vector<model::HistoryEntry>& history) {
  return json_array(history, [](const model::HistoryEntry& entry) {
    Json one = Json::object();
    one.set("action", entry.action).set("forced", entry.forced);
    one.set("rms_before_dph", entry.rms_before_dph).set("rms_after_dph", entry.rms_after_dph);
    one.set("noise_floor_dph", entry.noise_floor_dph);
    one.set("holdout_before_dph", entry.holdout ? Json(entry.holdout->rms_before_dph) : Json());
    one.set("holdout_after_dph", entry.holdout ? Json(entry.holdout->rms_after_dph) : Json());
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

}  // namespace

Json terms_json(const model::Model& model) {
  return json_array(model.terms, [](const model::EffectTerm& term) {
    const model::TermInfo info = model::info_of(term);
    Json one = Json::object();
    one.set("effect", term.name).set("title", info.title).set("equation", info.equation);
    one.set("words", effect_words(term)).set("is_expression", term.expression.has_value());
    one.set("parameters", parameters_json(term, info));
    one.set("coefficients", coefficients_json(term, info));
    one.set("doubt", findings::words(model::coefficient_doubt(term)).sentence());
    return one;
  });
}

Json model_json(const model::Model& model) {
  Json json = Json::object();
  json.set("text", model::model_text(model)).set("terms", terms_json(model));
  json.set("network", model.network.present()).set("history", history_json(model.history));
  json.set("correlations", correlations_json(model));
  json.set("residual_rms_dph", model.residual_rms_dph);
  json.set("average_s", model.average_s).set("derivative_tau_s", model.derivative_tau_s);
  return json;
}

}  // namespace fogcomp::workbench
