#include "workflow/plan.hpp"

#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/model.hpp"
#include "model/model_file.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/gyro_description.hpp"
#include "simulation/programme.hpp"
#include "support/input_error.hpp"

namespace fogcomp::workflow {
namespace {

constexpr planning::OperatingBox kUsualChamber{{-40, 85}, {-3, 3}, 0};

std::vector<model::EffectTerm> typical_terms(const std::string& list) {
  std::vector<model::EffectTerm> terms;
  for (const model::EffectTerm& term : model::parse_effects(list)) {
    terms.push_back(model::of_typical_size(term));
  }
  return terms;
}

// The question with noise of the simulator's part `noise`, in its units, over what it has.
planning::Question with_noise(const std::vector<std::string>& options,
                              planning::Question question) {
  constexpr double kRootHourInSeconds = 60;
  simulation::GyroDescription gyro;
  for (const std::string& option : options) {
    gyro.apply_option("--noise " + option, "noise:" + option);
  }
  const simulation::Parameters& noise = gyro.part("noise");
  for (const char* other : {"ramp", "quantization", "outliers", "outlier_dph"}) {
    if (noise.was_set(other)) {
      throw InputError("--noise", std::string("a plan knows white, flicker and random_walk, not ") +
                                      other + "; leave it out");
    }
  }
  if (noise.was_set("white")) question.white_dph_rthz = kRootHourInSeconds * noise["white"];
  if (noise.was_set("flicker")) question.flicker_dph = noise["flicker"];
  if (noise.was_set("random_walk")) question.walk_dph_per_rth = noise["random_walk"];
  if (!(question.white_dph_rthz > 0)) {
    throw InputError("--noise", "without white noise hours do not count; give white=0.001");
  }
  return question;
}

planning::Question question_of(const model::Model& model) {
  planning::Question question;
  for (const model::EffectTerm& term : model.terms) {
    if (!model::is_event(term)) question.terms.push_back(model::of_gyro(term));
  }
  question.derivative_tau_s = model.derivative_tau_s;
  question.white_dph_rthz = model.noise_dph_rthz;
  if (model.uncertainty) {
    question.flicker_dph = model.uncertainty->flicker_dph;
    question.walk_dph_per_rth = model.uncertainty->walk_dph_per_rth;
  }
  return question;
}

planning::Question question_of(const PlanRequest& request, const planning::OperatingBox& chamber) {
  if (request.model && request.effects) {
    throw InputError("--effects", "the model has effects; give it or --effects");
  }
  planning::Question question;
  question.use = chamber;
  if (request.model) {
    const model::Model model = model::load_model(*request.model);
    question = question_of(model);
    question.use = planning::box_of_runs(model, chamber);
  } else {
    question.terms = typical_terms(request.effects.value_or(model::kFirstEffects));
    question = with_noise({"white=0.00123,flicker=0.002"}, question);  // of the preset `paper`
  }
  question = with_noise(request.noise, question);
  question.use = planning::common_part(question.use, chamber);
  if (request.use) question.use = planning::parse_box("--use", *request.use, question.use);
  return question;
}

}  // namespace

PlanOutcome plan(const PlanRequest& request, const Observer& observer) {
  PlanOutcome outcome;
  outcome.request = request;
  outcome.chamber = request.chamber.empty()
                        ? kUsualChamber
                        : planning::parse_box("--chamber", request.chamber, kUsualChamber);
  outcome.question = question_of(request, outcome.chamber);
  if (!outcome.chamber.holds(outcome.question.use)) {
    throw InputError("--use", "the box of use, " + planning::box_text(outcome.question.use) +
                                  ", is more than the chamber does, " +
                                  planning::box_text(outcome.chamber) +
                                  "; give a smaller --use or another --chamber");
  }
  const planning::Foresight foresight(outcome.question);
  outcome.plan = planning::search_plan(
      foresight, {outcome.chamber, request.hours, request.seed, observer.of_stage("planning")});
  outcome.visible = foresight.visible(
      simulation::parse_profile(planning::profile_text(outcome.plan), "the plan", 1));
  return outcome;
}

PlanComparison compare_programmes(const PlanRequest& request,
                                  const std::vector<std::string>& programmes) {
  PlanComparison comparison;
  comparison.question = question_of(request, kUsualChamber);
  const planning::Foresight foresight(comparison.question);
  for (const std::string& name : programmes) {
    const simulation::Programme programme = simulation::parse_profile(
        simulation::find_text(name, simulation::ready_made_profiles(), "profile"), name,
        request.seed);
    comparison.programmes.push_back(
        {name, foresight.expect(programme), foresight.visible(programme)});
  }
  return comparison;
}

}  // namespace fogcomp::workflow
