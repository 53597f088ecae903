#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "model/catalogue.hpp"
#include "model/shape_parameter.hpp"
#include "support/text.hpp"

namespace fogcomp::model {

std::optional<double> HistoryEntry::excess_removed() const {
  if (!noise_floor_dph) return std::nullopt;
  const double before = rms_before_dph * rms_before_dph;
  const double excess = before - *noise_floor_dph * *noise_floor_dph;
  if (excess <= 0) return std::nullopt;
  return (before - rms_after_dph * rms_after_dph) / excess;
}

std::string Model::Uncertain::words() const {
  return format(
      "%s the drift is known to +- %.2g deg/h, worse than the %.2g deg/h that are to be "
      "compensated: for a board record %s, or leave effects out",
      at_power_on ? "at power-on" : "in a soak", sigma_dph, drift_dph,
      at_power_on ? "from power-on" : "more temperatures or rows");
}

std::vector<double> EffectTerm::shape() const {
  std::vector<double> values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.value);
  return values;
}

Eigen::VectorXd EffectTerm::coefficients() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(coefficients_dph.size()));
  std::transform(coefficients_dph.begin(), coefficients_dph.end(), values.begin(),
                 [](const Estimate& coefficient) { return coefficient.value; });
  return values;
}

void EffectTerm::set_coefficients(const Eigen::Ref<const Eigen::VectorXd>& values_dph) {
  coefficients_dph.resize(static_cast<std::size_t>(values_dph.size()));
  for (std::size_t i = 0; i < coefficients_dph.size(); ++i) {
    coefficients_dph[i].value = values_dph[static_cast<Eigen::Index>(i)];
  }
  gyro.reset();
}

const char* EffectTerm::bias_of_others() const {
  if (others_part == 0) return "before";
  return others_part == 1 ? "after" : "mean";
}

bool EffectTerm::has_first_heat() const {
  return expression && expression->expression.has(NodeKind::highest);
}

bool EffectTerm::acts_on(const std::vector<std::uint64_t>& recordings) const {
  return !recording ||
         std::find(recordings.begin(), recordings.end(), *recording) != recordings.end();
}

namespace {

Model with_more_bias(Model model, double dph) {
  if (dph == 0) return model;
  constexpr const char* kBias = "bias";
  const auto bias = std::find_if(model.terms.begin(), model.terms.end(),
                                 [](const EffectTerm& term) { return term.name == kBias; });
  if (bias == model.terms.end()) {
    model.terms.push_back({kBias, {}, {dph}});
  } else {
    bias->coefficients_dph[0].value += dph;
  }
  return model;
}

}  // namespace

Model as_it_acts_on(Model model, const std::vector<std::uint64_t>& recordings) {
  double bias_dph = 0;
  for (EffectTerm& term : model.terms) {
    if (!term.acts_on(recordings)) {
      for (Estimate& coefficient : term.coefficients_dph) coefficient.value = 0;
    } else if (term.others_part > 0) {
      bias_dph -= term.others_part * term.coefficients_dph[0].value;
    }
  }
  return with_more_bias(std::move(model), bias_dph);
}

Model after_exposure(Model model) {
  double bias_dph = 0;
  std::vector<EffectTerm> terms;
  for (EffectTerm& term : model.terms) {
    if (term.has_first_heat()) {
      Expression& expression = term.expression->expression;
      expression = expression.after_exposure_to(model.max_degc);
      if (expression.nodes.back().constant) {
        const double value = expression.constants(term.shape()).back();
        bias_dph +=
            std::ldexp(value, -term.expression->scale_log2) * term.coefficients_dph[0].value;
        continue;
      }
    }
    terms.push_back(std::move(term));
  }
  model.terms = std::move(terms);
  return with_more_bias(std::move(model), bias_dph);
}

const EffectTerm* Model::find(const std::string& name) const {
  const auto found = std::find_if(terms.begin(), terms.end(),
                                  [&](const EffectTerm& term) { return term.name == name; });
  return found == terms.end() ? nullptr : &*found;
}

double in_natural_unit(double coefficient_dph, const fog::CoefficientDescription& description) {
  return std::ldexp(coefficient_dph, -description.scale_log2) * description.per_unit;
}

Estimate natural_coefficient(const EffectTerm& term, std::size_t index) {
  const fog::CoefficientDescription description = info_of(term).coefficients[index];
  const Estimate& coefficient =
      term.gyro ? term.gyro->coefficients_dph[index] : term.coefficients_dph[index];
  return {in_natural_unit(coefficient.value, description),
          in_natural_unit(coefficient.sigma, description)};
}

Estimate shape_value(const EffectTerm& term, std::size_t index) {
  if (term.gyro) return term.gyro->shape[index];
  const Parameter& parameter = term.parameters[index];
  return {parameter.value, parameter.identified ? parameter.sigma : 0};
}

EffectTerm of_gyro(EffectTerm term) {
  if (!term.gyro) return term;
  for (std::size_t i = 0; i < term.parameters.size(); ++i) {
    term.parameters[i].value = term.gyro->shape[i].value;
    term.parameters[i].sigma = term.gyro->shape[i].sigma;
  }
  term.coefficients_dph = term.gyro->coefficients_dph;
  return term;
}

bool is_found_event(const EffectTerm& term) {
  return is_event(term) && term.parameters[0].identified;
}

Eigen::Index unknowns_of(const Model& model) {
  std::size_t count = 0;
  for (const EffectTerm& term : model.terms) {
    if (is_found_event(term)) continue;
    count += term.coefficients_dph.size() + shape_parameters({term}).size();
  }
  return static_cast<Eigen::Index>(count);
}

std::string describe(const Model& model) {
  std::string text;
  for (const EffectTerm& term : model.terms) {
    const TermInfo entry = info_of(term);
    text += format("  %-24s %s", term.name.c_str(), entry.equation.c_str());
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      const Parameter& parameter = term.parameters[i];
      if (parameter.is_left_at_zero()) continue;
      const Estimate value = shape_value(term, i);
      text += format(", %s %.5g", entry.parameters[i].name.c_str(), value.value);
      if (parameter.identified) text += format(" +- %.2g", value.sigma);
      if (!entry.parameters[i].unit.empty()) text += " " + entry.parameters[i].unit;
    }
    text += '\n';
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      const Estimate coefficient = natural_coefficient(term, i);
      text += format("  %24s %-4s = %12.5g +- %-9.2g %s\n", "", entry.coefficients[i].symbol,
                     coefficient.value, coefficient.sigma, entry.coefficients[i].unit);
    }
  }
  if (model.network.present()) {
    std::string inputs;
    for (const RealInput& input : model.network.inputs) {
      inputs += (inputs.empty() ? "" : ", ") + std::string(name_of(input.signal));
      if (input.tau_s > 0) inputs += format(" %.4g s", input.tau_s);
    }
    text += format("  %-24s %zu-%td-1 (%s), amplitude %.3g deg/h\n", "network",
                   model.network.inputs.size(), model.network.hidden.biases.size(), inputs.c_str(),
                   model.network.amplitude_dph);
  }
  return text;
}

EffectTerm of_typical_size(EffectTerm term) {
  const CatalogueEntry& entry = find_effect(term.name);
  std::map<std::string, double> sizes;
  for (const std::string& setting : split(entry.description.example, ' ')) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) continue;
    if (const auto value = parse_number(setting.substr(equals + 1))) {
      sizes[setting.substr(0, equals)] = *value;
    }
  }
  constexpr double kAnyBlock_s = 1;
  const std::size_t count = make_effect(term, kAnyBlock_s)->regressor_count();
  Eigen::VectorXd dph(static_cast<Eigen::Index>(count));
  double before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const fog::CoefficientDescription& coefficient = entry.coefficients[i];
    const auto found = sizes.find(coefficient.symbol);
    if (found != sizes.end()) {
      before = std::ldexp(found->second, coefficient.scale_log2) / coefficient.per_unit;
    }
    dph[static_cast<Eigen::Index>(i)] = before;
  }
  term.set_coefficients(dph);
  return term;
}

}  // namespace fogcomp::model
