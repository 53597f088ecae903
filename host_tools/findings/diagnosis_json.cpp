#include "findings/diagnosis_words.hpp"
#include "findings/json.hpp"

namespace fogcomp::findings {
namespace {

Json term_json(const model::EffectTerm& term) {
  return parameters_json(term).set(coefficients_json(term));
}

Json network_json(const std::optional<diagnosis::NetworkLearnt>& network) {
  if (!network) return Json();
  Json learnt = json_array(network->effects, [&](const diagnosis::NetworkLearnt::Share& share) {
    return Json::object()
        .set("effect", share.term.name)
        .set("share", share.share)
        .set("parameters", term_json(share.term));
  });
  Json result = Json::object();
  result.set("rms_dph", network->rms_dph).set("beyond_effects", network->beyond_effects);
  result.set("learnt", std::move(learnt));
  return result;
}

Json fast_json(const diagnosis::Diagnosis& diagnosis) {
  Json result = Json::object();
  switch (diagnosis.fast_kind) {
    case diagnosis::FastKind::none:
      return Json();
    case diagnosis::FastKind::line:
      result.set("kind", "line").set("period_s", diagnosis.fast.line_period_s);
      break;
    case diagnosis::FastKind::band:
      result.set("kind", "band").set("period_s", diagnosis.fast.band_period_s);
      break;
    case diagnosis::FastKind::two_levels:
      result.set("kind", "two_levels").set("height_dph", diagnosis.jumps.height_dph);
      result.set("dwell_s", diagnosis.jumps.dwell_s);
      break;
  }
  result.set("share", diagnosis.fast_share);
  return result;
}

Json shares_json(const std::vector<diagnosis::NamedShare>& shares) {
  return json_array(shares, [&](const diagnosis::NamedShare& share) {
    return Json::object().set("name", share.name).set("share", share.share);
  });
}

Json forms_json(const std::vector<diagnosis::Form>& forms) {
  return json_array(forms, [&](const diagnosis::Form& form) {
    return Json::object()
        .set("name", form.text)
        .set("expression", form.expression)
        .set("mechanisms", diagnosis::mechanisms_of(form.meaning))
        .set("share", form.share);
  });
}

Json candidates_json(const std::vector<diagnosis::CandidateFinding>& candidates) {
  return json_array(candidates, [&](const diagnosis::CandidateFinding& finding) {
    return Json::object()
        .set("effect", finding.effect)
        .set("explained_fraction", finding.explained_fraction)
        .set("rms_after_dph", finding.rms_after_dph)
        .set("evidence", finding.evidence)
        .set("probability", finding.probability)
        .set("lead", finding.lead)
        .set("visible_from_dph", finding.visible_from_dph)
        .set("parameters", term_json(finding.term()));
  });
}

// The missing effects, and the alternatives.
Json verdict_json(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next) {
  std::vector<std::string> effects = next.together;
  if (effects.empty() && !diagnosis.effect.empty()) effects = {diagnosis.effect};
  const bool proposed = diagnosis.experiment && !diagnosis.experiment->sentence.empty();
  Json untestable = json_array(diagnosis.untestable, [&](const diagnosis::Untestable& effect) {
    return Json::object().set("effect", effect.effect).set("needs", effect.needs);
  });
  Json explanations =
      json_array(diagnosis.explanations, [&](const diagnosis::Diagnosis::Explanation& explanation) {
        return Json::object()
            .set("effects", explanation.effects)
            .set("probability", explanation.probability)
            .set("explained_fraction", explanation.explained_fraction);
      });
  return Json::object()
      .set("verdict", diagnosis::name_of(diagnosis.verdict))
      .set("effect", text_or_null(diagnosis.effect))
      .set("effects", effects)
      .set("confusable", diagnosis.confusable)
      .set("experiment",
           text_or_null(proposed ? diagnosis.experiment->sentence : diagnosis.blind_spot))
      .set("experiment_profile", text_or_null(proposed ? diagnosis.experiment->profile : ""))
      .set("candidates", candidates_json(diagnosis.candidates))
      .set("untestable", std::move(untestable))
      .set("explanations", std::move(explanations));
}

// Size of the residual relative to the noise.
Json residual_json(const diagnosis::Diagnosis& diagnosis) {
  Json as_given = member_or_null(diagnosis.as_given, [](const compare::BoardError& given) {
    return Json::object()
        .set("residual_rms_dph", given.rms_dph)
        .set("residual_rms_without_delay_dph", given.without_delay_dph);
  });
  return Json::object()
      .set("residual_rms_dph", diagnosis.residual_rms_dph)
      .set("as_given", std::move(as_given))
      .set("outliers", diagnosis.outliers)
      .set("noise_floor_dph", diagnosis.noise_floor_dph)
      .set("unexplained_fraction", diagnosis.unexplained_fraction)
      .set("noise", Json::object()
                        .set("white_dph", diagnosis.noise.white_dph())
                        .set("slow_dph", diagnosis.noise.wander_dph())
                        .set("freedom", diagnosis.noise.degrees_of_freedom)
                        .set("from_quiet_parts", diagnosis.noise.from_quiet_parts));
}

std::string kind_of(const diagnosis::AdditionRequest& request) {
  if (request.refines) return "refinement";
  if (!request.expression.empty()) return "expression";
  return request.is_network() ? "network" : "effects";
}

// A description that lowers the error without naming a cause; null if there is none or an effect is
// named.
Json description_json(const diagnosis::NextStep& next) {
  if (!next.describes || !next.addition) return Json();
  const diagnosis::TriedAddition& trial = *next.addition;
  return Json::object()
      .set("kind", kind_of(trial.request))
      .set("effects", trial.request.effects)
      .set("expression", text_or_null(trial.request.expression))
      .set("rms_before_dph", trial.rms_before_dph)
      .set("rms_after_dph", trial.rms_after_dph);
}

Json refused_json(const diagnosis::NextStep& next) {
  return json_array(next.refused, [](const diagnosis::TriedAddition& trial) {
    return Json::object()
        .set("effects", trial.request.effects)
        .set("expression", text_or_null(trial.request.expression))
        .set("reason", trial.reason);
  });
}

}  // namespace

Json diagnosis_json(const diagnosis::Diagnosis& diagnosis, const diagnosis::NextStep& next,
                    const DiagnosedFiles& files) {
  return verdict_json(diagnosis, next)
      .set("description", description_json(next))
      .set("forms", forms_json(next.forms))
      .set("next", text_or_null(words_of(diagnosis, next, files).command))
      .set("refused", refused_json(next))
      .set("fast", fast_json(diagnosis))
      .set("where", Json::object()
                        .set("variable", diagnosis.variable)
                        .set("variables", shares_json(diagnosis.variables))
                        .set("segments", shares_json(diagnosis.segments)))
      .set(residual_json(diagnosis))
      .set("random_walk_dph_per_rth", diagnosis.walk_dph_per_rth)
      .set("network", network_json(diagnosis.network))
      .set("nothing_missing", diagnosis.nothing)
      .set("something_else", diagnosis.something_else)
      .set("faint", diagnosis.verdict == diagnosis::Verdict::unknown && diagnosis.may_be_noise())
      .set("notes", diagnosis.notes);
}

Json ladder_json(const diagnosis::Ladder& ladder, const DiagnosedFiles& files) {
  using Judged = model::HistoryEntry::Holdout;
  Json steps = json_array(ladder.steps, [&](const diagnosis::Ladder::Step& step) {
    const diagnosis::TriedAddition& tried = step.addition;
    return Json::object()
        .set("effects", tried.request.effects)
        .set("expression", text_or_null(tried.request.expression))
        .set("cuts", cuts_json(tried.request.cuts))
        .set("describes", step.describes)
        .set("alternatives", step.alternatives)
        .set("rms_before_dph", tried.fitted_before_dph)
        .set("rms_after_dph", tried.fitted_after_dph)
        .set("out_of_sample_rms_before_dph", tried.rms_before_dph)
        .set("out_of_sample_rms_after_dph", tried.rms_after_dph)
        .set("holdout_rms_before_dph", member_or_null(tried.holdouts, &Judged::rms_before_dph))
        .set("holdout_rms_after_dph", member_or_null(tried.holdouts, &Judged::rms_after_dph));
  });
  Json result = diagnosis_json(ladder.first, ladder.next, files);
  result.set("added", ladder.added()).set("described", ladder.described());
  result.set("ladder", std::move(steps));
  result.set("commands", ladder_commands(ladder, files));
  result.set("model", text_or_null(files.output));
  diagnosis::NextStep nothing_holds;
  nothing_holds.refused = ladder.last_next.refused;
  result.set("last", diagnosis_json(ladder.last, nothing_holds, files));
  return result;
}

}  // namespace fogcomp::findings
