#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "findings/findings.hpp"
#include "support/json.hpp"

/// Output of `--json`: every value of a finding, by stable names.
namespace fogcomp::findings {

/// Array of a member of each element, or of what a function of each returns.
template <class Elements, class Member>
Json members(const Elements& elements, Member member) {
  return json_array(elements,
                    [&](const auto& element) { return Json(std::invoke(member, element)); });
}

/// What is known of something, else null.
template <class Value, class Member>
Json member_or_null(const Value* value, Member member) {
  return value == nullptr ? Json() : Json(std::invoke(member, *value));
}
template <class Value, class Member>
Json member_or_null(const std::optional<Value>& value, Member member) {
  return member_or_null(value ? &*value : nullptr, member);
}
/// A text, null if it is empty.
inline Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json info_json(const recording::Recording& recording, const compare::RunSummary& summary,
               const planning::Prospect& prospect = {});
Json visible_json(const std::vector<planning::VisibleSize>& sizes);

/// `output`: the model file that was written.
Json fit_json(const workflow::FitOutcome& fit, const std::string& output);

/// Null without a prior.
Json prior_json(const workflow::FitOutcome& fit);

/// The first model's runs at the top level; all models under "models".
Json compare_json(const std::vector<compare::ModelOnRuns>& models);

Json diagnosis_json(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                    const DiagnosedFiles& files);
/// The diagnosis of the given model, the steps of the selection, and the diagnosis at its end,
/// whose model has no file.
Json ladder_json(const diagnosis::Ladder& ladder, const DiagnosedFiles& files);

/// Cuts as --cut takes them.
Json cuts_json(const std::vector<recording::Cut>& cuts);

/// `written`: the new model file, "" for none.
Json add_json(const fit::Addition& addition, const std::string& written);

/// `profile`: the file that was written.
Json plan_json(const workflow::PlanOutcome& outcome, const std::string& profile);
Json comparison_json(const workflow::PlanComparison& comparison);

Json paper_json(const std::vector<research::Study>& studies);

/// Object of "turn_on_bias", of the second run, the third, ... relative to the first, certain or
/// not, and "turn_on_repeatability".
Json turn_on_json(const compare::TurnOn& turn_on);

/// `output`: folder of the results. `calibrated`, `already_done`: numbers of gyros, now and before.
Json batch_json(const batch::Summary& summary, const std::string& output, std::size_t calibrated,
                std::size_t already_done);

/// Shape parameters and coefficients by name, coefficients in their own units.
Json parameters_json(const model::EffectTerm& term);
Json coefficients_json(const model::EffectTerm& term);

}  // namespace fogcomp::findings
