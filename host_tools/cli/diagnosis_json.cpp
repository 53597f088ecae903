#include "cli/diagnosis_json.hpp"

#include "cli/term_json.hpp"

namespace fogcomp::cli {
namespace {

Json parameters_json(const EffectTerm& term) {
  Json parameters = Json::object();
  set_parameters(parameters, term);
  set_coefficients(parameters, term);
  return parameters;
}

Json names_json(const std::vector<std::string>& names) {
  Json array = Json::array();
  for (const std::string& name : names) array.push(name);
  return array;
}

Json network_json(const std::optional<NetworkLearnt>& network) {
  if (!network) return Json();
  Json learnt = Json::array();
  for (const NetworkLearnt::Share& share : network->effects) {
    learnt.push(std::move(Json::object()
                              .set("effect", share.term.name)
                              .set("share", share.share)
                              .set("parameters", parameters_json(share.term))));
  }
  Json result = Json::object();
  result.set("rms_dph", network->rms_dph).set("beyond_effects", network->beyond_effects);
  result.set("learnt", std::move(learnt));
  return result;
}

Json fast_json(const Diagnosis& diagnosis) {
  Json result = Json::object();
  switch (diagnosis.fast_kind) {
    case FastKind::none:
      return Json();
    case FastKind::line:
      result.set("kind", "line").set("period_s", diagnosis.fast.line_period_s);
      break;
    case FastKind::band:
      result.set("kind", "band").set("period_s", diagnosis.fast.band_period_s);
      break;
    case FastKind::two_levels:
      result.set("kind", "two_levels").set("height_dph", diagnosis.jumps.height_dph);
      result.set("dwell_s", diagnosis.jumps.dwell_s);
      break;
  }
  return result;
}

Json shares_json(const std::vector<Diagnosis::Share>& shares) {
  Json all = Json::array();
  for (const Diagnosis::Share& share : shares) {
    all.push(std::move(Json::object().set("name", share.name).set("share", share.share)));
  }
  return all;
}

}  // namespace

Json diagnosis_json(const Diagnosis& diagnosis) {
  Json candidates = Json::array();
  for (const CandidateFinding& finding : diagnosis.candidates) {
    candidates.push(std::move(Json::object()
                                  .set("effect", finding.effect)
                                  .set("explained_fraction", finding.explained_fraction)
                                  .set("rms_after_dph", finding.rms_after_dph)
                                  .set("evidence", finding.evidence)
                                  .set("probability", finding.probability)
                                  .set("parameters", parameters_json(finding.term()))));
  }
  Json explanations = Json::array();
  for (const Diagnosis::Explanation& explanation : diagnosis.explanations) {
    explanations.push(std::move(Json::object()
                                    .set("effects", names_json(explanation.effects))
                                    .set("probability", explanation.probability)
                                    .set("explained_fraction", explanation.explained_fraction)));
  }
  Json untestable = Json::array();
  for (const Untestable& effect : diagnosis.untestable) {
    untestable.push(
        std::move(Json::object().set("effect", effect.effect).set("needs", effect.needs)));
  }
  Json result = Json::object();
  result.set("verdict", name_of(diagnosis.verdict));
  if (diagnosis.effect.empty()) {
    result.set("effect", Json());
  } else {
    result.set("effect", diagnosis.effect);
  }
  result.set("confusable", names_json(diagnosis.confusable));
  const bool proposed = diagnosis.experiment && !diagnosis.experiment->sentence.empty();
  result.set("experiment", proposed ? Json(diagnosis.experiment->sentence) : Json());
  const bool recordable = proposed && !diagnosis.experiment->profile.empty();
  result.set("experiment_profile", recordable ? Json(diagnosis.experiment->profile) : Json());
  result.set("candidates", std::move(candidates)).set("untestable", std::move(untestable));
  result.set("explanations", std::move(explanations)).set("tests", diagnosis.tests);
  result.set("fast", fast_json(diagnosis));
  result.set("where", std::move(Json::object()
                                    .set("variable", diagnosis.variable)
                                    .set("variables", shares_json(diagnosis.variables))
                                    .set("segments", shares_json(diagnosis.segments))));
  result.set("residual_rms_dph", diagnosis.residual_rms_dph);
  result.set("noise_floor_dph", diagnosis.noise_floor_dph);
  result.set("unexplained_fraction", diagnosis.unexplained_fraction);
  result.set("noise", std::move(Json::object()
                                    .set("white_dph", diagnosis.noise.white_dph())
                                    .set("slow_dph", diagnosis.noise.wander_dph())
                                    .set("freedom", diagnosis.noise.freedom)
                                    .set("from_quiet_parts", diagnosis.noise.from_quiet_parts)));
  result.set("network", network_json(diagnosis.network));
  result.set("chance", diagnosis.chance).set("notes", names_json(diagnosis.notes));
  return result;
}

Json ladder_json(const Ladder& ladder) {
  Json steps = Json::array();
  for (const Ladder::Step& step : ladder.steps) {
    steps.push(std::move(Json::object()
                             .set("effect", step.effect)
                             .set("removed", step.removed)
                             .set("alternatives", names_json(step.alternatives))
                             .set("rms_before_dph", step.rms_before_dph)
                             .set("rms_after_dph", step.rms_after_dph)));
  }
  Json result = diagnosis_json(ladder.first);
  result.set("added", names_json(ladder.added())).set("ladder", std::move(steps));
  result.set("left_alone", ladder.left_alone.empty() ? Json() : Json(ladder.left_alone));
  result.set("last", diagnosis_json(ladder.last));
  return result;
}

}  // namespace fogcomp::cli
