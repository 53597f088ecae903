#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/addition_judge.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/form_meaning.hpp"

namespace fogcomp::diagnosis {

/// A formula that may describe the residual.
struct Form {
  std::string text;        ///< as a reader wants it: lag(dTdt^2,tau)
  std::string expression;  ///< `NAME = EXPRESSION` with the bounds of its parameters, for `add`
  FormMeaning meaning{};
  double share = 0;  ///< how likely it is the largest part
};

/// A possible description of the residual and the fraction it explains.
struct Description {
  AdditionRequest request;
  double explained_fraction = 0;
  bool is_part = false;  ///< a certain part of the missing drift, the rest being unknown
  std::vector<std::string> effects{};  ///< names of a set
};

/// Those of the named effects that are no events.
std::vector<std::string> without_events(const Diagnosis& diagnosis,
                                        std::vector<std::string> effects);

/// Events that are to be added before anything else: those named, and those that are missing as
/// surely as an effect has to be to be named, whatever else is missing.
std::vector<std::string> first_events(const Diagnosis& diagnosis,
                                      const std::vector<std::string>& named);

/// The request for `add`; nothing for an expression or a bias step together with others: `add`
/// takes effects, one expression, or cuts.
std::optional<AdditionRequest> request_of(const Diagnosis& diagnosis,
                                          const std::vector<std::string>& effects);

/// What may be missing in place of `named`, which was refused, most probable first: effects that
/// are as certainly missing as a name has to be, then sets that may be all (rules::kConfusable).
/// Events are added one at a time, as cuts: a set with one is given without it if two effects are
/// left.
std::vector<Description> rivals_of(const Diagnosis& diagnosis,
                                   const std::vector<std::string>& named);

/// Formulas that may be what is missing.
struct LikelyFormulas {
  std::vector<Form> forms;                ///< best first
  std::vector<Description> descriptions;  ///< of the same
  std::optional<Experiment> experiment;   ///< that would tell these apart
  double chance = 1;            ///< that noise alone would look like this, all formulas counted
  bool show_something = false;  ///< that chance is as small as a diagnosis asks, and no walk's
};
/// Diagnoses again, with all formulas over temperature, its rate and the one other input on which
/// the residual depends (formulas_over()) beside the catalogue.
LikelyFormulas likely_formulas(const model::Model& model, const Diagnosis& diagnosis,
                               const DiagnosisData& data, const DiagnosisSettings& settings);

}  // namespace fogcomp::diagnosis
