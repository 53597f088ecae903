#include "findings/diagnosis_words.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "compare/comparison.hpp"
#include "findings/figures.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "noise/outlier_rows.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

constexpr double kSlowCycle_s = 7200;  // no machine of a laboratory is that slow

std::string joined(const std::vector<std::string>& names, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : format(" %s ", last);
    text += names[i];
  }
  return text;
}

std::string add_command_line(const diagnosis::AdditionRequest& request, const std::string& model,
                             const DiagnosedFiles& files) {
  std::vector<std::string> line{"fogcomp", "add", model};
  line.insert(line.end(), request.effects.begin(), request.effects.end());
  line.insert(line.end(), files.runs.begin(), files.runs.end());
  if (!request.expression.empty()) {
    line.insert(line.end(), {"--effect-expr", request.expression});
  }
  for (const std::string& holdout : files.holdouts) {
    line.insert(line.end(), {"--holdout", holdout});
  }
  line.insert(line.end(), files.reading.begin(), files.reading.end());
  line.insert(line.end(), {"-o", files.output.empty() ? "NEW.model" : files.output});
  return shell_words(line);
}

std::string what_is_tried(const diagnosis::AdditionRequest& request) {
  return request.expression.empty() ? joined(request.effects, "and") : request.expression;
}

std::string walk_words(const diagnosis::Diagnosis& diagnosis) {
  return format(
      "a random walk of the bias of %.2g deg/h/sqrt(h) explains as well as any effect: the "
      "programme once more, or a recording at rest with --static, would tell",
      diagnosis.walk.coefficient);
}

// What is said, and how certain it is.
using Headline = std::pair<std::string, std::string>;

Headline missing_words(const diagnosis::Diagnosis& diagnosis) {
  const diagnosis::CandidateFinding* finding = diagnosis.find(diagnosis.effect);
  const std::string described = shape_words(finding->term());
  return {format("missing effect: %s (%s)", diagnosis.effect.c_str(),
                 model::info_of(finding->term()).title.c_str()),
          format("probability %.2f%s", finding->probability,
                 described.empty() ? "" : ("; " + described).c_str())};
}

Headline unknown_words(const diagnosis::Diagnosis& diagnosis, bool main_part_holds) {
  if (diagnosis.fast_kind != diagnosis::FastKind::none) {
    return {std::string("something is missing that no effect of the catalogue explains: ") +
                (diagnosis.fast_kind == diagnosis::FastKind::two_levels ? "jumps between two levels"
                                                                        : "cycles"),
            ""};
  }
  if (diagnosis.walk.may_be_all()) {
    return {"slow changes are left, which no effect explains better than noise",
            "they are what " + walk_words(diagnosis)};
  }
  const std::string surely = diagnosis::effect_to_add(diagnosis);
  if (!surely.empty() && main_part_holds) {
    return {surely + " is missing, and something more that no effect of the catalogue explains (" +
                percent(diagnosis.unexplained_fraction) + " of all)",
            ""};
  }
  const bool offered = std::any_of(
      diagnosis.candidates.begin(), diagnosis.candidates.end(),
      [](const diagnosis::CandidateFinding& finding) { return finding.is_expression(); });
  return {"something is missing that no effect of the catalogue" +
              std::string(offered ? " and no expression offered" : "") + " explains (" +
              percent(diagnosis.unexplained_fraction) + " of it is left unexplained)",
          ""};
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
      return {"an effect is missing; these recordings cannot tell which of",
              joined(diagnosis.confusable, "or")};
    case diagnosis::Verdict::unknown:
      break;
  }
  return unknown_words(diagnosis, main_part_holds);
}

std::string size_words(const diagnosis::Diagnosis& diagnosis, const std::string& effect) {
  std::string text = format("the model leaves %.4g deg/h rms; the noise floor is %.4g",
                            diagnosis.residual_rms_dph, diagnosis.noise_floor_dph);
  if (const diagnosis::CandidateFinding* finding = diagnosis.find(effect)) {
    text += format("; with %s %.4g", effect.c_str(), finding->rms_after_dph);
  }
  return text;
}

// Why `compare` has another figure, where it has: it shows the model as it is.
std::string as_given_words(const diagnosis::Diagnosis& diagnosis) {
  constexpr double kTellsApart = 0.01;
  if (!diagnosis.as_given) return "";
  const compare::BoardError& given = *diagnosis.as_given;
  const double apart = std::abs(given.rms_dph - diagnosis.residual_rms_dph);
  if (apart <= kTellsApart * given.rms_dph) return "";
  return "that is refitted to these runs and without the board's delay; of the model as it is, " +
         compare::delay_words(given);
}

// nullptr where these effects are no set that competes.
const diagnosis::Diagnosis::Explanation* find_explanation(const diagnosis::Diagnosis& diagnosis,
                                                          const std::vector<std::string>& effects) {
  const auto set = std::find_if(
      diagnosis.explanations.begin(), diagnosis.explanations.end(),
      [&](const diagnosis::Diagnosis::Explanation& one) { return one.effects == effects; });
  return set == diagnosis.explanations.end() ? nullptr : &*set;
}

// What only together lowers the error.
std::string together_words(const diagnosis::Diagnosis& diagnosis,
                           const std::vector<std::string>& together) {
  const auto* set = find_explanation(diagnosis, together);
  if (set == nullptr) return "";
  return joined(together, "and") + " together explain " + percent(set->explained_fraction) +
         format(" of what is above the noise (probability %.2f); each alone hardly helps",
                set->probability);
}

std::string where_words(const diagnosis::Diagnosis& diagnosis) {
  std::vector<diagnosis::NamedShare> segments = diagnosis.segments;
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, segments.size()); ++i) {
    if (segments[i].share < 0.1) break;
    text += (text.empty() ? "it sits in " : ", ") + segments[i].name + " (" +
            percent(segments[i].share) + ")";
  }
  if (!diagnosis.variable.empty()) {
    text += (text.empty() ? "it depends most on " : "; it depends most on ") + diagnosis.variable;
  }
  return text;
}

// What no function of the inputs describes.
std::string fast_words(const diagnosis::Diagnosis& diagnosis) {
  switch (diagnosis.fast_kind) {
    case diagnosis::FastKind::none:
      break;
    case diagnosis::FastKind::line:
      if (diagnosis.fast.line_period_s > kSlowCycle_s) {
        return format("it repeats every %.3g h: look for the day, the room, its air conditioning",
                      diagnosis.fast.line_period_s / kSecondsPerHour);
      }
      return format("it repeats every %.3g s: look for a cooler, a compressor, a control loop",
                    diagnosis.fast.line_period_s);
    case diagnosis::FastKind::band:
      return format("there is more than noise around periods of %.3g s, %.0f %% above it",
                    diagnosis.fast.band_period_s, 100 * diagnosis.fast.band_excess);
    case diagnosis::FastKind::two_levels:
      return format(
          "the bias jumps to and fro between two levels %.3g deg/h apart, each held for %.2g s on "
          "average: look at light source, detector and electronics",
          diagnosis.jumps.height_dph, diagnosis.jumps.dwell_s);
  }
  return "";
}

// Far beyond the draws of the test the tail of their distribution is a guess.
std::string chance_words(double chance) {
  constexpr double kTiny = 1e-6;
  return "chance that noise alone looks like this: " +
         (chance < kTiny ? "less than one in a million" : format("%.2g", chance));
}

// What the network, which the diagnosis leaves out, had learnt.
std::string network_words(const diagnosis::Diagnosis& diagnosis) {
  constexpr double kSaysNothing = 0.05;   // difference of shares that says nothing
  constexpr double kNextToNothing = 0.1;  // of the noise floor
  if (!diagnosis.network) return "";
  const diagnosis::NetworkLearnt& network = *diagnosis.network;
  std::string text = format("the network, left out here, adds %.4g deg/h rms", network.rms_dph);
  if (network.rms_dph < kNextToNothing * diagnosis.noise_floor_dph) {
    return text + ": next to nothing";
  }
  text += ", " + percent(network.beyond_effects) + " of it beyond the model's own effects: ";
  if (network.effects.empty() || network.effects[0].share < diagnosis::kLearntShare) {
    text += "nothing of the catalogue explains what it had learnt";
    if (network.effects.empty()) return text;
    return text + " (at most " + percent(network.effects[0].share) + ", " +
           network.effects[0].term.name + ")";
  }
  // Of those that explain it alike, the one that the verdict names.
  diagnosis::NetworkLearnt::Share best = network.effects[0];
  for (const diagnosis::NetworkLearnt::Share& share : network.effects) {
    const bool as_well = share.share > network.effects[0].share - kSaysNothing;
    if (as_well && share.term.name == diagnosis.effect) best = share;
  }
  text += "it had learnt " + best.term.name + " (explains " + percent(best.share);
  std::vector<std::string> alike;
  for (const diagnosis::NetworkLearnt::Share& share : network.effects) {
    const bool as_well =
        share.share > best.share - kSaysNothing && share.term.name != best.term.name;
    if (as_well) alike.push_back(share.term.name);
  }
  if (!alike.empty()) text += "; so would " + joined(alike, "or");
  return text + "): add the effect and train a smaller network";
}

// Of what lowers the error and is not the cause, as far as anyone knows.
std::vector<std::string> description_words(const diagnosis::NextStep& next) {
  std::vector<std::string> lines;
  if (!next.forms.empty()) {
    std::string text = "outside the catalogue it looks like " + next.forms[0].text +
                       format(" (%.2f)", next.forms[0].share);
    for (std::size_t i = 1; i < std::min<std::size_t>(3, next.forms.size()); ++i) {
      text += (i == 1 ? ", rather than " : " or ") + next.forms[i].text +
              format(" (%.2f)", next.forms[i].share);
    }
    lines.push_back(text);
  }
  if (next.addition) {
    const bool one = next.addition->request.names().size() == 1;
    lines.push_back(
        what_is_tried(next.addition->request) +
        format(" %s the error out of sample from %s to %s deg/h: this describes it, it does "
               "not say what it is. Beyond the trained temperatures it is held at its value there",
               one ? "lowers" : "lower", rounded(next.addition->rms_before_dph).c_str(),
               rounded(next.addition->rms_after_dph).c_str()));
  }
  if (next.experiment && !next.experiment->sentence.empty()) {
    lines.push_back("to tell: " + next.experiment->sentence);
  } else if (next.addition) {
    lines.push_back(
        "a run of another programme, given to add with --holdout, would tell whether it "
        "holds there, too");
  }
  return lines;
}

// Why nothing is proposed; "" where nothing was tried. The first was named, or describes most.
std::string nothing_holds_words(const diagnosis::NextStep& next) {
  if (next.little_is_left) {
    return "nothing to add: what is left is so little beside what was taken out that it may be the "
           "inexactness of what is there: let a run that was not fitted decide, with --holdout";
  }
  if (next.refused.empty()) return "";
  std::string text = "nothing to add: " + what_is_tried(next.refused[0].request) +
                     " was tried and refused, " + next.refused[0].reason;
  std::vector<std::string> others;
  for (std::size_t i = 1; i < next.refused.size(); ++i) {
    others.push_back(what_is_tried(next.refused[i].request));
  }
  return others.empty() ? text : text + "; so were: " + join(others, "; ");
}

void add_next(DiagnosisWords& words, const diagnosis::NextStep& next, const DiagnosedFiles& files) {
  if (next.addition) {
    words.command = add_command_line(next.addition->request, files.model, files);
  } else {
    words.next = nothing_holds_words(next);
  }
}

}  // namespace

std::string shape_words(const model::EffectTerm& term) {
  std::string text;
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const model::TermInfo::Parameter& parameter = info.parameters[i];
    if (model::is_left_at_zero(term, i)) continue;
    text += (text.empty() ? "" : ", ") +
            format("%s %.3g", parameter.name.c_str(), term.parameters[i]) +
            (parameter.unit.empty() ? "" : " " + parameter.unit);
  }
  return text;
}

DiagnosisWords words_of(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                        const DiagnosedFiles& files) {
  DiagnosisWords words;
  std::tie(words.verdict, words.certainty) = verdict_words(diagnosis, !next.describes);
  if (!next.together.empty()) {
    words.verdict = "several effects together are missing: " + joined(next.together, "and");
    words.certainty = diagnosis.verdict == diagnosis::Verdict::ambiguous
                          ? "these recordings cannot tell which is the largest: " + words.certainty
                          : "";
  }
  words.findings.push_back(
      size_words(diagnosis, next.describes ? "" : diagnosis::effect_to_add(diagnosis)));
  const std::string as_given = as_given_words(diagnosis);
  if (!as_given.empty()) words.findings.push_back(as_given);
  const std::string together = together_words(diagnosis, next.together);
  if (!together.empty()) words.findings.push_back(together);
  if (diagnosis.verdict != diagnosis::Verdict::none) {
    const std::string where = where_words(diagnosis);
    if (!where.empty()) words.findings.push_back(where);
    const std::string fast = fast_words(diagnosis);
    if (!fast.empty()) words.findings.push_back(fast);
    if (diagnosis.experiment && !diagnosis.experiment->sentence.empty()) {
      words.findings.push_back("to tell: " + diagnosis.experiment->sentence);
    }
    if (next.describes) {
      for (const std::string& line : description_words(next)) words.findings.push_back(line);
    }
    add_next(words, next, files);
  }
  if (diagnosis.outliers > 0)
    words.limits.push_back(noise::outlier_words(diagnosis.outliers, diagnosis.row_s));
  words.limits.push_back(chance_words(diagnosis.chance));
  const std::string network = network_words(diagnosis);
  if (!network.empty()) words.limits.push_back(network);
  for (const std::string& note : diagnosis.notes) words.limits.push_back("note: " + note);
  if (const diagnosis::CandidateFinding* finding =
          diagnosis.find(diagnosis::effect_to_add(diagnosis))) {
    for (const model::ShapeDoubt& doubt : model::shape_doubts(finding->term())) {
      words.limits.push_back("note: " + doubt.sentence);
    }
  }
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
    brief.sentence = joined(next.together, "and") + " are missing together";
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
        joined(diagnosis.confusable, "or") + " is missing, these recordings cannot tell which";
  } else {
    std::string what = fast_words(diagnosis);
    if (what.empty() && !diagnosis.variable.empty()) {
      what = "it depends most on " + diagnosis.variable;
    }
    brief.sentence = "something is missing that no effect of the catalogue explains";
    if (!what.empty()) brief.sentence += " (" + what + ")";
  }
  brief.sentence += ": " + rounded(brief.size_dph) + " deg/h rms";
  if (brief.probability) brief.sentence += format(", probability %.2f", *brief.probability);
  return brief;
}

std::string step_words(const diagnosis::Ladder::Step& step) {
  std::string what = "+ " + what_is_tried(step.addition.request);
  if (step.describes) what += " (a description)";
  if (!step.alternatives.empty()) what += " (or " + joined(step.alternatives, "or") + ")";
  return what;
}

std::vector<std::string> ladder_commands(const diagnosis::Ladder& ladder,
                                         const DiagnosedFiles& files) {
  std::vector<std::string> lines;
  std::string model = files.model;
  for (const diagnosis::Ladder::Step& step : ladder.steps) {
    lines.push_back(add_command_line(step.addition.request, model, files));
    model = files.output.empty() ? "NEW.model" : files.output;
  }
  return lines;
}

std::string end_words(const diagnosis::Ladder& ladder) {
  if (!ladder.left_alone.empty()) {
    return ladder.left_alone + " holds out of sample and leaves more in these rows: not added";
  }
  const auto [verdict, certainty] = verdict_words(ladder.last);
  std::string text = "at the end: " + verdict + (certainty.empty() ? "" : "; " + certainty);
  const diagnosis::NextStep& next = ladder.last_next;
  const std::string why = next.addition ? "" : nothing_holds_words(next);
  return why.empty() ? text : text + "; " + why;
}

}  // namespace fogcomp::findings
