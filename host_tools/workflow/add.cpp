#include "workflow/add.hpp"

#include <algorithm>

#include "model/catalogue.hpp"
#include "support/input_error.hpp"

namespace fogcomp::workflow {
namespace {

// Those with which no step of the model was made.
std::vector<recording::Cut> new_cuts(std::vector<recording::Cut> cuts, const model::Model& model) {
  const auto is_known = [&](const recording::Cut& cut) {
    const std::string words = " --cut " + cut_text(cut) + " ";
    return std::any_of(model.history.begin(), model.history.end(), [&](const auto& step) {
      return (step.action + " ").find(words) != std::string::npos;
    });
  };
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(), is_known), cuts.end());
  if (cuts.empty()) {
    throw InputError("--cut", "the model has been made with it; give another one, or an effect");
  }
  return cuts;
}

fit::EffectChange change_of(const AddRequest& request, const model::Model& model) {
  if (request.expression) return fit::change_expression(model.terms, *request.expression);
  if (request.only_cuts) {
    return fit::change_cuts(model.terms, new_cuts(request.reading.cuts, model));
  }
  return fit::change_effects(model.terms, request.effects);
}

}  // namespace

fit::Addition add(const AddRequest& request, const Observer& observer) {
  return add(request, judging_runs(request, {}, observer), observer);
}

fit::Addition add(const AddRequest& request, const runs::Runs& runs, const Observer& observer) {
  model::Model model = model::load_model(request.model);
  observer.say(model::leave_out_events(model.terms));
  const fit::EffectChange change = change_of(request, model);
  remember_reading(request.reading, model);
  observer.say(runs.notes);
  observer.tell(kTraining, 0);
  return fit::add_effect(model, change, runs,
                         {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
