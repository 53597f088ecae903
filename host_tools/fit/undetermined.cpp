#include "fit/undetermined.hpp"

#include <algorithm>
#include <map>

#include "fit/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "model/input_value.hpp"
#include "series/term_columns.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// Meaning of a column of a fit's matrix.
struct Unknown {
  std::size_t term = 0;  // number of terms: belongs to no term
  std::string name;
  bool is_shape = false;
};

std::vector<Unknown> unknowns_of(const NoiseWeightedFit& fit, const series::Rows& rows) {
  std::vector<Unknown> unknowns;
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  for (std::size_t term = 0; term < fit.terms.size(); ++term) {
    const model::TermInfo info = model::info_of(fit.terms[term]);
    for (Eigen::Index i = 0; i < columns[term].count; ++i) {
      unknowns.push_back({term, info.coefficients[static_cast<std::size_t>(i)].symbol, false});
    }
  }
  for (auto i = static_cast<Eigen::Index>(unknowns.size()); i < fit.linear(); ++i) {
    unknowns.push_back({fit.terms.size(), "the offset of a recording", false});
  }
  for (const model::ShapeParameter& shape : fit.shapes) {
    unknowns.push_back(
        {shape.term, model::info_of(fit.terms[shape.term]).parameters[shape.index].name, true});
  }
  return unknowns;
}

std::string whose(const NoiseWeightedFit& fit, const Unknown& unknown) {
  if (unknown.term >= fit.terms.size()) return unknown.name;
  return fit.terms[unknown.term].name + "'s " + unknown.name;
}

std::string enumeration(const std::vector<std::string>& names) {
  if (names.size() < 2) return join(names, "");
  return join({names.begin(), names.end() - 1}, ", ") + " and " + names.back();
}

template <class Value>
double span_of(const series::Rows& rows, const Value& value) {
  double min = value(rows.signals[0]);
  double max = min;
  for (const auto& signals : rows.signals) {
    min = std::min(min, value(signals));
    max = std::max(max, value(signals));
  }
  return max - min;
}

// Property of the rows because of which a term is undetermined; "" if none is obvious.
std::string known_reason(const model::EffectTerm& term, const series::Rows& rows) {
  const fog::InputMask needs = model::info_of(term).needs;
  for (const fog::Input input : model::kOptionalInputs) {
    if (!has(needs, input)) continue;
    if (span_of(rows, [&](const auto& s) { return model::optional_input(input, s.block); }) > 0)
      continue;
    return std::string(description_of(input).column) + " never changes";
  }
  if (has(needs, fog::Input::elapsed) &&
      rows.time_s[0] > rules::kLateStart * rows.longest_run_s()) {
    return format("time_s begins at %.10g s: is it since power-on?", rows.time_s[0]);
  }
  const double span_degc = span_of(rows, [](const auto& s) { return s.temperature; });
  if (needs == 0 && span_degc < rules::kStillDegc) {
    return format("the temperature moves by no more than %.2g degC", span_degc);
  }
  return "";
}

// Undetermined unknowns of one term, for the message.
struct Blame {
  std::vector<std::string> coefficients;
  std::vector<std::string> shapes;
  std::vector<std::string> made_of;  // of the first coefficient
};

std::string remedy(const model::EffectTerm& term, const Blame& blame) {
  if (term.expression) {
    return blame.shapes.empty()
               ? "leave the expression out"
               : "narrow the bounds, write a value instead or leave the expression out";
  }
  const auto& parameters = model::find_effect(term.name).parameters;
  const bool all_optional =
      std::all_of(parameters.begin(), parameters.end(), [&](const auto& parameter) {
        return model::is_optional_part(parameter) ||
               std::find(blame.shapes.begin(), blame.shapes.end(), parameter.name) ==
                   blame.shapes.end();
      });
  if (!blame.shapes.empty() && all_optional) return "leave " + enumeration(blame.shapes) + " out";
  if (!blame.shapes.empty()) {
    return "give " + term.name + ":" + join(blame.shapes, "=VALUE,") +
           "=VALUE or leave the effect out";
  }
  const bool has_order =
      std::any_of(parameters.begin(), parameters.end(),
                  [](const auto& parameter) { return parameter.scale == fog::Scale::whole; });
  return has_order ? "lower its order or leave the effect out" : "leave the effect out";
}

std::map<std::size_t, Blame> blames_of(const NoiseWeightedFit& fit, const series::Rows& rows) {
  const std::vector<Unknown> unknowns = unknowns_of(fit, rows);
  std::map<std::size_t, Blame> blames;
  for (const DependentColumn& dependent : dependent_columns(fit.whitened)) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(dependent.column)];
    Blame& blame = blames[unknown.term];
    const bool first = blame.coefficients.empty() && blame.shapes.empty();
    (unknown.is_shape ? blame.shapes : blame.coefficients).push_back(unknown.name);
    if (!first || unknown.is_shape) continue;
    for (const Eigen::Index column : dependent.on) {
      blame.made_of.push_back(whose(fit, unknowns[static_cast<std::size_t>(column)]));
    }
  }
  return blames;
}

}  // namespace

bool has_constant_input_rate(fog::InputMask needs, const series::Rows& rows) {
  return needs == bit_of(fog::Input::input_rate) &&
         span_of(rows, [](const auto& signals) { return signals.block.input_rate; }) == 0;
}

void require_varying_input_rate(const std::vector<model::EffectTerm>& terms,
                                const series::Rows& rows) {
  for (const model::EffectTerm& term : terms) {
    if (term.expression || !has_constant_input_rate(model::info_of(term).needs, rows)) continue;
    throw InputError(term.name,
                     "these recordings do not determine it (input_rate_dph never "
                     "changes: the input rate does not move); leave the effect out");
  }
}

bool is_determined(const NoiseWeightedFit& fit) {
  return fit.covariance.size() > 0 && fit.covariance.allFinite();
}

void refuse_undetermined(const NoiseWeightedFit& fit, const series::Rows& rows) {
  const std::map<std::size_t, Blame> blames = blames_of(fit, rows);
  const auto& [first, blame] = *blames.begin();
  if (first >= fit.terms.size()) {
    throw InputError("--run-offsets", "these recordings do not determine " +
                                          enumeration(blame.coefficients) + "; leave it out");
  }
  const model::EffectTerm& term = fit.terms[first];
  std::vector<std::string> names = blame.coefficients;
  names.insert(names.end(), blame.shapes.begin(), blame.shapes.end());
  std::string text = "these recordings do not determine " + enumeration(names);
  std::vector<std::string> others;
  for (auto other = std::next(blames.begin()); other != blames.end(); ++other) {
    for (const auto* list : {&other->second.coefficients, &other->second.shapes}) {
      for (const std::string& name : *list) {
        others.push_back(whose(fit, {other->first, name, false}));
      }
    }
  }
  if (!others.empty()) text += ", nor " + enumeration(others);
  const std::string reason = known_reason(term, rows);
  if (!reason.empty()) {
    text += " (" + reason + ")";
  } else if (!blame.made_of.empty()) {
    text += " (on these rows it is made up of " + enumeration(blame.made_of) + ")";
  }
  const std::string where = term.expression ? "expression '" + term.name + "'" : term.name;
  throw InputError(where, text + "; " + remedy(term, blame));
}

}  // namespace fogcomp::fit
