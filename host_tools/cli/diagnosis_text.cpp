#include "cli/diagnosis_text.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::cli {
namespace {

constexpr std::size_t kMostCandidates = 6;

std::string percent(double share) {
  return format("%.0f %%", 100 * share);
}

std::string joined(const std::vector<std::string>& names, const char* last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : format(" %s ", last);
    text += names[i];
  }
  return text;
}

// "radius 5.2 degC"
std::string shape(const EffectTerm& term) {
  std::string text;
  const TermInfo info = info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const TermInfo::Parameter& parameter = info.parameters[i];
    if (term.parameters[i] == 0 && parameter.bounds.least > 0) continue;
    text += (text.empty() ? "" : ", ") +
            format("%s %.3g", parameter.name.c_str(), term.parameters[i]) +
            (parameter.unit.empty() ? "" : " " + parameter.unit);
  }
  return text;
}

bool is_expression(const CandidateFinding& finding) {
  return finding.term().expression.has_value();
}

// How to name an effect to `add`, with what it takes to grow one that is there already.
std::string to_add(const Diagnosis& diagnosis, const std::string& effect) {
  const CandidateFinding* finding = diagnosis.find(effect);
  const auto own = std::find_if(diagnosis.terms.begin(), diagnosis.terms.end(),
                                [&](const EffectTerm& term) { return term.name == effect; });
  if (own == diagnosis.terms.end() || finding == nullptr) return effect;
  const CatalogueEntry& entry = find_effect(effect);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    if (finding->term().parameters[i] == own->parameters[i]) continue;
    return format("%s:%s=%.4g", effect.c_str(), entry.parameters[i].name,
                  finding->term().parameters[i]);
  }
  return effect;
}

// The command that adds it. An expression has no quotes in it.
std::string add_command_line(const Diagnosis& diagnosis, const std::string& effect,
                             const std::string& model, const std::string& runs) {
  const CandidateFinding* finding = diagnosis.find(effect);
  if (finding == nullptr || !is_expression(*finding)) {
    return "fogcomp add " + model + " " + to_add(diagnosis, effect) + " " + runs;
  }
  const Expression& expression = finding->term().expression->expression;
  return "fogcomp add " + model + " " + runs + " --effect-expr '" + expression.name + " = " +
         expression.text + "'";
}

std::string verdict_line(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case Verdict::none:
      return "nothing is missing: what is left is noise, as far as these recordings can show\n";
    case Verdict::missing_effect: {
      const CandidateFinding* finding = diagnosis.find(diagnosis.effect);
      const std::string described = shape(finding->term());
      return format("missing effect: %s (%s)\n", diagnosis.effect.c_str(),
                    info_of(finding->term()).title.c_str()) +
             format("  probability %.2f%s\n", finding->probability,
                    described.empty() ? "" : ("; " + described).c_str());
    }
    case Verdict::ambiguous:
      return "an effect is missing; these recordings cannot tell which of\n  " +
             joined(diagnosis.confusable, "or") + "\n";
    case Verdict::unknown:
      break;
  }
  const bool offered =
      std::any_of(diagnosis.candidates.begin(), diagnosis.candidates.end(), is_expression);
  return "something is missing that no effect of the catalogue" +
         std::string(offered ? " and no expression offered" : "") + " explains (" +
         percent(diagnosis.unexplained_fraction) + " of it is left unexplained)\n";
}

std::string error_line(const Diagnosis& diagnosis) {
  std::string text = format("  the model leaves %.4g deg/h rms; the noise floor is %.4g",
                            diagnosis.residual_rms_dph, diagnosis.noise_floor_dph);
  const std::string effect = effect_to_add(diagnosis);
  if (const CandidateFinding* finding = diagnosis.find(effect)) {
    text += format("; with %s %.4g", effect.c_str(), finding->rms_after_dph);
  }
  return text + "\n";
}

std::string where_line(const Diagnosis& diagnosis) {
  std::vector<Diagnosis::Share> segments = diagnosis.segments;
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, segments.size()); ++i) {
    if (segments[i].share < 0.1) break;
    text += (text.empty() ? "  it sits in " : ", ") + segments[i].name + " (" +
            percent(segments[i].share) + ")";
  }
  if (!diagnosis.variable.empty()) {
    text += (text.empty() ? "  it depends most on " : "; it depends most on ") + diagnosis.variable;
  }
  return text.empty() ? "" : text + "\n";
}

std::string next_line(const Diagnosis& diagnosis, const std::string& model,
                      const std::string& runs) {
  std::string text;
  if (diagnosis.experiment && !diagnosis.experiment->sentence.empty()) {
    text += "  to tell: " + diagnosis.experiment->sentence + "\n";
  }
  const std::string effect = effect_to_add(diagnosis);
  if (effect == kBiasStep) {
    text += "  next: fit again with bias_step among the --effects: it finds steps and masks them\n";
  } else if (!effect.empty()) {
    text += "  next: " + add_command_line(diagnosis, effect, model, runs) + " -o NEW.model\n";
  } else if (diagnosis.verdict == Verdict::unknown) {
    text +=
        "  next: let a formula of your own compete: --effect-expr 'NAME = T*T*dTdt' "
        "(host_tools/README.md, Expressions)\n";
  }
  return text;
}

// What the network, which the diagnosis leaves out, had learnt.
std::string network_lines(const Diagnosis& diagnosis) {
  constexpr double kAlike = 0.05;         // difference of shares that says nothing
  constexpr double kNextToNothing = 0.1;  // of the noise floor
  if (!diagnosis.network) return "";
  const NetworkLearnt& network = *diagnosis.network;
  std::string text = format("  the network, left out here, adds %.4g deg/h rms", network.rms_dph);
  if (network.rms_dph < kNextToNothing * diagnosis.noise_floor_dph) {
    return text + ": next to nothing\n";
  }
  text += ", " + percent(network.beyond_effects) + " of it beyond the model's own effects: ";
  if (network.effects.empty() || network.effects[0].share < kLearntShare) {
    text += "nothing of the catalogue explains what it had learnt";
    if (network.effects.empty()) return text + "\n";
    return text + " (at most " + percent(network.effects[0].share) + ", " +
           network.effects[0].term.name + ")\n";
  }
  // Of those that explain it alike, the one that the verdict names.
  NetworkLearnt::Share best = network.effects[0];
  for (const NetworkLearnt::Share& share : network.effects) {
    const bool as_well = share.share > network.effects[0].share - kAlike;
    if (as_well && share.term.name == diagnosis.effect) best = share;
  }
  text += "it had learnt " + best.term.name + " (explains " + percent(best.share);
  std::vector<std::string> alike;
  for (const NetworkLearnt::Share& share : network.effects) {
    const bool as_well = share.share > best.share - kAlike && share.term.name != best.term.name;
    if (as_well) alike.push_back(share.term.name);
  }
  if (!alike.empty()) text += "; so would " + joined(alike, "or");
  return text + "): add the effect and train a smaller network\n";
}

std::string candidate_table(const Diagnosis& diagnosis) {
  std::string text =
      "\n  candidate                  explains  rms after   ln odds  probability  shape\n";
  std::size_t shown = 0;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    if (shown >= kMostCandidates && !is_expression(finding)) continue;
    ++shown;
    text += format("  %-26s %7.0f%% %10.4g %9.1f %12.3f  %s\n", finding.effect.c_str(),
                   100 * finding.explained_fraction, finding.rms_after_dph, finding.evidence,
                   finding.probability, shape(finding.term()).c_str());
  }
  return text;
}

std::string untestable_lines(const Diagnosis& diagnosis) {
  if (diagnosis.untestable.empty()) return "";
  std::string text = "\n  not to be seen in these recordings: ";
  for (std::size_t i = 0; i < diagnosis.untestable.size(); ++i) {
    text += (i == 0 ? "" : ", ") + diagnosis.untestable[i].effect + " (needs " +
            diagnosis.untestable[i].needs + ")";
  }
  return text + "\n";
}

}  // namespace

std::string diagnosis_text(const Diagnosis& diagnosis, const std::string& model,
                           const std::string& runs) {
  std::string text = verdict_line(diagnosis) + error_line(diagnosis);
  if (diagnosis.verdict != Verdict::none) {
    text += where_line(diagnosis) + next_line(diagnosis, model, runs);
  }
  text += format("  chance that noise alone looks like this: %.2g\n", diagnosis.chance);
  text += network_lines(diagnosis);
  for (const std::string& note : diagnosis.notes) text += "  note: " + note + "\n";
  if (!diagnosis.candidates.empty()) text += candidate_table(diagnosis);
  return text + untestable_lines(diagnosis);
}

std::string ladder_text(const Ladder& ladder) {
  std::string text =
      format("\nerror ladder, deg/h rms (noise floor %.4g)\n  %-44s %10.4g\n",
             ladder.first.noise_floor_dph, "the model, refitted", ladder.first.residual_rms_dph);
  for (const Ladder::Step& step : ladder.steps) {
    std::string what = (step.removed ? "- " : "+ ") + step.effect;
    if (step.removed) what += " (no longer needed)";
    if (!step.alternatives.empty()) what += " (or " + joined(step.alternatives, "or") + ")";
    text += format("  %-44s %10.4g\n", what.c_str(), step.rms_after_dph);
  }
  if (ladder.steps.empty()) return text + "  nothing to add\n";
  if (!ladder.left_alone.empty()) {
    return text + "  " + ladder.left_alone +
           " would bring so little more that it may be the inexactness of what is there: not "
           "added\n";
  }
  text += "at the end: " + verdict_line(ladder.last);
  return text;
}

}  // namespace fogcomp::cli
