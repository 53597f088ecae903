#include <cmath>

#include "findings/json.hpp"

namespace fogcomp::findings {
namespace {

Json expectation_json(const planning::Expectation& expectation) {
  return Json::object()
      .set("hours", expectation.hours)
      .set("sigma_dph", expectation.error.sigma_dph())
      .set("sigma_of_noise_dph", expectation.error.noise_dph)
      .set("sigma_of_formulas_dph", expectation.error.formulas_dph);
}

}  // namespace

Json visible_json(const std::vector<planning::VisibleSize>& sizes) {
  return json_array(sizes, [](const planning::VisibleSize& size) {
    return Json::object()
        .set("effect", size.effect)
        .set("typical_dph", size.typical_dph)
        .set("visible_dph", std::isfinite(size.visible_dph) ? Json(size.visible_dph) : Json());
  });
}

Json plan_json(const workflow::PlanOutcome& outcome, const std::string& profile) {
  const planning::Plan& plan = outcome.plan;
  Json steps = Json::array();
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const planning::Step& step = plan.steps[i];
    steps.push(Json::object()
                   .set("to_degc", step.to_degc)
                   .set("ramp_degc_per_min", step.ramp_degc_per_min)
                   .set("soak_min", step.soak_min)
                   .set("rate_dps", step.rate_dps)
                   .set("sigma_dph", plan.sigma_after_dph[i]));
  }
  return Json::object()
      .set("profile", profile)
      .set("use", planning::box_text(outcome.question.use))
      .set(expectation_json(plan.expectation))
      .set("start_degc", plan.start_degc)
      .set("steps", std::move(steps))
      .set("visible", visible_json(outcome.visible));
}

Json comparison_json(const workflow::PlanComparison& comparison) {
  return Json::object()
      .set("use", planning::box_text(comparison.question.use))
      .set("programmes",
           json_array(comparison.programmes, [](const workflow::PlanComparison::One& one) {
             return Json::object()
                 .set("programme", one.name)
                 .set(expectation_json(one.expectation))
                 .set("visible", visible_json(one.visible));
           }));
}

}  // namespace fogcomp::findings
