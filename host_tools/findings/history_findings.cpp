#include "findings/findings.hpp"

#include <algorithm>

#include "findings/text.hpp"
#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

using Steps = std::vector<model::HistoryEntry>;

// A list of effects that can be broken into lines.
Text action_of(const model::HistoryEntry& step) {
  return verbatim(join(split(step.action, ','), ", "));
}

Text found(const Steps& steps) {
  Text text = words(counted(steps.size(), "step")) + ": from " +
              number(steps.front().rms_before_dph) + " to " + number(steps.back().rms_after_dph) +
              " deg/h rms";
  if (const auto floor = steps.back().noise_floor_dph) {
    text += "; noise alone would leave " + number(*floor);
  }
  return text;
}

Table steps_table(const Steps& steps) {
  Table table;
  table.columns = {"step", "before", "after", "of excess", "held out", "data"};
  table.notes =
      "rms left, deg/h; of excess: of what lay above the noise floor, the part that the step "
      "removed; held out: on runs that it was not fitted to; data: hash of the recordings, within "
      "which errors compare";
  for (const model::HistoryEntry& step : steps) {
    const auto removed = step.excess_removed();
    const Text held_out = step.holdout ? number(step.holdout->rms_before_dph) + " -> " +
                                             number(step.holdout->rms_after_dph)
                                       : Text("-");
    const Text forced = step.forced ? " (forced: did not help out of sample)" : "";
    table.rows.push_back({action_of(step) + forced, number(step.rms_before_dph),
                          number(step.rms_after_dph),
                          words(removed ? percent(*removed) : std::string("-")), held_out,
                          words(format("%08x", static_cast<unsigned>(step.data_hash)))});
  }
  return table;
}

Table terms_table(const model::Model& model) {
  Table table;
  table.columns = {"effect", "figure", "value", "+-", "unit"};
  for (const model::EffectTerm& term : model.terms) {
    const model::TermInfo info = model::info_of(term);
    const std::size_t first = table.rows.size();
    for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
      const auto [value, sigma] = model::natural_coefficient(term, i);
      table.rows.push_back({"", words(info.coefficients[i].symbol), significant(value),
                            significant(sigma), words(info.coefficients[i].unit)});
    }
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      const model::Estimate own = model::shape_value(term, i);
      table.rows.push_back({"", words(info.parameters[i].name), significant(own.value),
                            term.parameters[i].identified ? significant(own.sigma) : Text("given"),
                            words(info.parameters[i].unit)});
    }
    if (table.rows.size() == first) continue;
    table.rows[first].cells[0] = verbatim(
        term.expression ? term.name + " = " + term.expression->expression.text : term.name);
  }
  return table;
}

}  // namespace

Table error_ladder(const model::Model& model) {
  const Steps& history = model.history;
  Table table;
  table.caption = "what is left of the data of the fit";
  table.columns = {"step", {"rms left", "residual"}};
  table.quantity = "rms left, deg/h";
  table.floor = history.back().noise_floor_dph.value_or(0);
  // A model that went on has been fitted to other data before.
  const auto first = std::find_if(history.rbegin(), history.rend(), [&](const auto& step) {
                       return step.data_hash != history.back().data_hash;
                     }).base();
  const double before_dph = first->rms_before_dph;
  Table::Row before{first == history.begin() ? "by a constant alone" : "the model before",
                    {number(before_dph), before_dph}};
  before.colour = "measured";
  table.rows.push_back(std::move(before));
  for (auto step = first; step != history.end(); ++step) {
    table.rows.push_back({action_of(*step), {number(step->rms_after_dph), step->rms_after_dph}});
  }
  return table;
}

Document history_findings(const model::Model& model, const std::string& file) {
  Document document{"fogcomp history " + file, found(model.history)};
  document.parts = Heading{"Error ladder"} + error_ladder(model);
  document.parts += Heading{"Steps"} + steps_table(model.history);
  document.parts += Heading{"Model"} + terms_table(model);
  if (model.network.present()) {
    document.parts += Sentence{
        words("and a network of " +
              counted(static_cast<std::size_t>(model.network.hidden.biases.size()), "neuron") +
              " on what these leave")};
  }
  return document;
}

}  // namespace fogcomp::findings
