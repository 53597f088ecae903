#include "findings/diagnosis_words.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "board/delays.hpp"
#include "compare/comparison.hpp"
#include "diagnosis/descriptions.hpp"
#include "findings/text.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "noise/outlier_rows.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

constexpr double kLikely = 0.5;  // probability from which a set "is" missing

// A verdict and its certainty.
using Headline = std::pair<std::string, std::string>;

Headline missing_words(const diagnosis::Diagnosis& diagnosis) {
  const diagnosis::CandidateFinding* finding = diagnosis.find(diagnosis.effect);
  const std::string described = shape_words(finding->term());
  return {format("missing effect: %s (%s)", diagnosis.effect.c_str(),
                 model::info_of(finding->term()).title.c_str()),
          format("%s %.2f%s", diagnosis.effect.c_str(), finding->probability,
                 described.empty() ? "" : (" (" + described + ")").c_str())};
}

// How probably each is the largest of what is missing.
std::string lead_words(const diagnosis::Diagnosis& diagnosis) {
  std::vector<std::string> leads;
  for (const std::string& name : diagnosis.confusable) {
    const diagnosis::CandidateFinding* const finding = diagnosis.find(name);
    if (finding != nullptr) leads.push_back(name + format(" %.2f", finding->lead));
  }
  return join(leads, ", ");
}

Headline unknown_words(const diagnosis::Diagnosis& diagnosis, bool main_part_holds) {
  if (diagnosis.only_by_formula) {
    return {
        "something is missing: what looks like slow noise follows a formula outside the catalogue",
        ""};
  }
  if (!diagnosis.withdrawn.empty()) {
    return {"something is missing: what looks like " + diagnosis.withdrawn +
                " does not hold out of sample",
            ""};
  }
  const bool is_fast = diagnosis.fast_kind != diagnosis::FastKind::none;
  const std::string fast = diagnosis.fast_kind == diagnosis::FastKind::two_levels
                               ? "jumps between two levels"
                               : "cycles";
  const std::string surely = diagnosis::effect_to_add(diagnosis);
  if (!surely.empty() && main_part_holds) {
    return {
        surely + " is missing, and something more that no effect of the catalogue explains" +
            (is_fast ? ": " + fast : " (" + percent(diagnosis.unexplained_fraction) + " of all)"),
        ""};
  }
  if (is_fast) {
    return {"something is missing that no effect of the catalogue explains: " + fast, ""};
  }
  if (diagnosis.may_be_noise()) {
    if (diagnosis.leaves_noise()) return {"something may be missing, too faint to be named", ""};
    return {"slow changes are left, which may be noise", diagnosis.walk_words()};
  }
  const bool offered = std::any_of(
      diagnosis.candidates.begin(), diagnosis.candidates.end(),
      [](const diagnosis::CandidateFinding& finding) { return finding.is_expression(); });
  return {
      "something is missing, which these recordings do not name: the best three effects of the "
      "catalogue" +
          std::string(offered ? " and the expressions offered" : "") + " leave " +
          percent(diagnosis.unexplained_fraction) + " of it unexplained",
      ""};
}

// One name alone, where several further ones share what is left of the probability.
std::string which_words(const std::vector<std::string>& confusable) {
  return confusable.size() == 1
             ? confusable[0] + ", or something that is no effect of the catalogue"
             : join_list(confusable, "or") + "; these recordings cannot tell which";
}

Headline verdict_words(const diagnosis::Diagnosis& diagnosis, bool main_part_holds = true) {
  switch (diagnosis.verdict) {
    case diagnosis::Verdict::none:
      if (!diagnosis.blind_spot.empty()) {
        return {"nothing is missing that these recordings can show", diagnosis.blind_spot};
      }
      return {"nothing is missing: what is left is noise, as far as these recordings can show", ""};
    case diagnosis::Verdict::missing_effect:
      return missing_words(diagnosis);
    case diagnosis::Verdict::ambiguous:
      return {"an effect is missing: " + which_words(diagnosis.confusable), lead_words(diagnosis)};
    case diagnosis::Verdict::unknown:
      break;
  }
  return unknown_words(diagnosis, main_part_holds);
}

// nullptr if these effects are not one of the competing sets.
const diagnosis::Diagnosis::Explanation* find_explanation(const diagnosis::Diagnosis& diagnosis,
                                                          const std::vector<std::string>& effects) {
  const auto set = std::find_if(
      diagnosis.explanations.begin(), diagnosis.explanations.end(),
      [&](const diagnosis::Diagnosis::Explanation& one) { return one.effects == effects; });
  return set == diagnosis.explanations.end() ? nullptr : &*set;
}

// Effects that are missing together, and what each brings alone.
std::string together_words(const diagnosis::Diagnosis& diagnosis,
                           const std::vector<std::string>& together) {
  const auto* set = find_explanation(diagnosis, together);
  if (set == nullptr) return "";
  std::vector<std::string> alone;
  for (const std::string& effect : together) {
    const diagnosis::CandidateFinding* const finding = diagnosis.find(effect);
    if (finding != nullptr) alone.push_back(percent(finding->explained_fraction));
  }
  return format("the set %.2f, explains ", set->probability) + percent(set->explained_fraction) +
         " of what is above the noise, alone " + join_list(alone, "and");
}

// The reason why nothing is proposed; "" where nothing is missing that could be named.
std::string why_nothing(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  const std::string text = nothing_holds_words(next);
  if (!text.empty() || diagnosis.verdict == diagnosis::Verdict::none || diagnosis.may_be_noise())
    return text;
  return "nothing to add: no effect and no formula that is known here explains enough of it to be "
         "tried";
}

// The named effect where it was tried and something else is proposed: "; aging was tried ...".
std::string refused_name(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  std::string text;
  if (diagnosis.verdict == diagnosis::Verdict::unknown || !next.addition) return text;
  for (const diagnosis::TriedAddition& refused : next.refused) {
    const bool is_named = refused.request.names() == std::vector<std::string>{diagnosis.effect};
    if (is_named) text += "; " + refusal_words(refused);
  }
  return text;
}

// What is not known of the shape of what is named: "; `aging`: t0 is at its upper bound ...".
std::string doubts_of_name(const diagnosis::Diagnosis& diagnosis) {
  std::string text;
  if (const auto* const finding = diagnosis.find(diagnosis::effect_to_add(diagnosis))) {
    for (const std::string& doubt : model::shape_doubts(finding->term())) text += "; " + doubt;
  }
  return text;
}

// Of what the verdict names first, then of the others; reservations last.
Headline headline_of(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  const std::string others = probability_words(diagnosis);
  if (!next.together.empty()) {
    const auto* const set = find_explanation(diagnosis, next.together);
    const bool likely = set == nullptr || set->probability >= kLikely;
    const std::string together = together_words(diagnosis, next.together);
    return {std::string("several effects together ") + (likely ? "are" : "may be") +
                " missing: " + join_list(next.together, "and"),
            together.empty() ? others : together + "; " + others};
  }
  const auto [verdict, certainty] = verdict_words(diagnosis, !next.describes);
  if (certainty.empty()) return {verdict, others};
  const bool is_named = diagnosis.verdict == diagnosis::Verdict::missing_effect ||
                        diagnosis.verdict == diagnosis::Verdict::ambiguous;
  return {verdict, is_named ? certainty + "; " + others : others + "; " + certainty};
}

// What would tell, and what lowers the error without naming a cause.
std::vector<std::string> more_words(const diagnosis::Diagnosis& diagnosis,
                                    const diagnosis::NextStep& next) {
  const bool is_none = diagnosis.verdict == diagnosis::Verdict::none;
  std::vector<std::string> lines;
  if (next.describes && (!is_none || next.addition)) lines = description_words(next);
  if (is_none) return lines;
  if (diagnosis.experiment && !diagnosis.experiment->sentence.empty()) {
    lines.insert(lines.begin(), "to tell: " + diagnosis.experiment->sentence);
  }
  if (!fast_words(diagnosis).empty()) lines.insert(lines.begin(), where_words(diagnosis));
  return lines;
}

std::vector<std::string> limit_words(const diagnosis::Diagnosis& diagnosis,
                                     const diagnosis::NextStep& next) {
  std::vector<std::string> limits;
  if (diagnosis.outliers > 0)
    limits.push_back(noise::outlier_words(diagnosis.outliers, diagnosis.row_s));
  const std::string network = network_words(diagnosis);
  if (!network.empty()) limits.push_back(network);
  for (const std::string& note : diagnosis.notes) limits.push_back("note: " + note);
  if (next.only_with_own_biases) {
    limits.push_back("note: " + join_list(next.addition->request.names(), "and") +
                     " with a bias of its own for each power-on holds better than anything with "
                     "one bias for all");
  }
  if (next.only_between_recordings) {
    limits.push_back("note: " + join_list(next.addition->request.names(), "and") +
                     " shows between the recordings, with one bias for all of them; within them "
                     "nothing is missing");
  }
  return limits;
}

}  // namespace

std::string shape_words(const model::EffectTerm& term) {
  std::string text;
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const model::TermInfo::Parameter& parameter = info.parameters[i];
    const double value = term.parameters[i].value;
    if (term.parameters[i].is_left_at_zero()) continue;
    text += (text.empty() ? "" : ", ") + parameter.name +
            format(std::fabs(value) < 1000 ? " %.3g" : " %.0f", value) +
            (parameter.unit.empty() ? "" : " " + parameter.unit);
  }
  return text;
}

DiagnosisWords words_of(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                        const DiagnosedFiles& files) {
  DiagnosisWords words;
  const bool is_none = diagnosis.verdict == diagnosis::Verdict::none;
  std::tie(words.verdict, words.certainty) = headline_of(diagnosis, next);
  words.size = size_words(diagnosis, next);
  if (is_none && next.addition) {
    words.verdict = "no effect is missing, but " +
                    join_list(next.addition->request.names(), "and") + " can be refined";
  }
  if (!is_none) {
    words.certainty += doubts_of_name(diagnosis) + refused_name(diagnosis, next);
    const std::string fast = fast_words(diagnosis);
    words.place = fast.empty() ? where_words(diagnosis) : fast;
  }
  if (next.addition) {
    words.command = add_command_line(next.addition->request, files.model, files);
  } else if (!is_none) {
    words.next = why_nothing(diagnosis, next);
  }
  words.findings = more_words(diagnosis, next);
  words.limits = limit_words(diagnosis, next);
  return words;
}

BriefDiagnosis in_brief(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  const double left_dph = diagnosis.residual_rms_dph;
  BriefDiagnosis brief;
  brief.size_dph = compare::floor_removed(left_dph, diagnosis.noise_floor_dph);
  if (diagnosis.verdict == diagnosis::Verdict::none) {
    brief.sentence = "no effect is missing: " + rounded(left_dph) +
                     " deg/h rms is left, noise alone is " + rounded(diagnosis.noise_floor_dph);
    return brief;
  }
  if (!next.together.empty()) {
    brief.effects = next.together;
    if (const auto* set = find_explanation(diagnosis, next.together)) {
      brief.probability = set->probability;
    }
    brief.sentence = join_list(next.together, "and") + " are missing together";
  } else if (const diagnosis::CandidateFinding* named = diagnosis.find(diagnosis.effect)) {
    brief.effects = {diagnosis.effect};
    brief.size_dph = compare::floor_removed(left_dph, named->rms_after_dph);
    brief.probability = named->probability;
    const bool is_there =
        std::any_of(diagnosis.terms.begin(), diagnosis.terms.end(),
                    [&](const model::EffectTerm& term) { return term.name == diagnosis.effect; });
    brief.sentence = is_there ? "the model's " + diagnosis.effect + " is incomplete"
                              : diagnosis.effect + " is missing";
  } else if (!diagnosis.confusable.empty()) {
    brief.effects = diagnosis.confusable;
    brief.sentence =
        join_list(diagnosis.confusable, "or") + " is missing, these recordings cannot tell which";
  } else {
    std::string what = fast_words(diagnosis);
    if (what.empty() && !diagnosis.variable.empty()) {
      what = "it depends most on " + variable_label(diagnosis.variable).plain();
    }
    brief.sentence = "something is missing that no effect of the catalogue explains";
    if (!what.empty()) brief.sentence += " (" + what + ")";
  }
  brief.sentence += ": " + rounded(brief.size_dph) + " deg/h rms";
  if (brief.probability) brief.sentence += format(", probability %.2f", *brief.probability);
  return brief;
}

std::string settling_words(const diagnosis::Ladder& ladder) {
  const std::optional<diagnosis::TriedAddition>& proposed = ladder.next.addition;
  const bool is_proposed = ladder.steps.empty() && proposed && proposed->model;
  return board::settling_words(is_proposed ? *proposed->model : ladder.model);
}

std::string end_words(const diagnosis::Ladder& ladder) {
  const auto [verdict, certainty] = verdict_words(ladder.last, !ladder.last_next.describes);
  std::string text = "at the end: " + verdict + (certainty.empty() ? "" : "; " + certainty);
  const diagnosis::NextStep& next = ladder.last_next;
  const bool was_not_looked_for =
      ladder.is_cut_off && ladder.last.verdict != diagnosis::Verdict::none;
  const std::string why = next.addition        ? ""
                          : was_not_looked_for ? "not tried, as the loop may add no more"
                                               : why_nothing(ladder.last, next);
  return why.empty() ? text : text + "; " + why;
}

}  // namespace fogcomp::findings
