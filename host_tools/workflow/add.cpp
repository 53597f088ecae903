#include "workflow/add.hpp"

#include <algorithm>

#include "model/catalogue.hpp"
#include "support/input_error.hpp"

namespace fogcomp::workflow {
namespace {

// Those with which the model was not made, in runs to which it is fitted.
std::vector<recording::Cut> new_cuts(std::vector<recording::Cut> cuts, const model::Model& model,
                                     const runs::Runs& runs) {
  const auto is_known = [&](const recording::Cut& cut) {
    return std::find(model.cuts.begin(), model.cuts.end(), cut_text(cut)) != model.cuts.end();
  };
  const auto only_judges = [&](const recording::Cut& cut) {
    return std::none_of(runs.training.begin(), runs.training.end(),
                        [&](runs::Run run) { return runs::set_cut(run, cut, true); });
  };
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(), is_known), cuts.end());
  if (cuts.empty()) {
    throw InputError("--cut", "the model has been made with it; give another one, or an effect");
  }
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(), only_judges), cuts.end());
  if (cuts.empty()) {
    throw InputError("--cut",
                     "lies in a holdout alone, where nothing is fitted; give an effect to "
                     "add, or a cut of a run");
  }
  return cuts;
}

fit::EffectChange change_of(const AddRequest& request, const model::Model& model,
                            const runs::Runs& runs) {
  if (request.expression) return fit::change_expression(model.terms, *request.expression);
  if (request.only_cuts) {
    return fit::change_cuts(model.terms, new_cuts(request.reading.cuts, model, runs));
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
  const fit::EffectChange change = change_of(request, model, runs);
  remember_reading(request.reading, model);
  model.samples = runs::samples_of(runs.training);
  observer.say(runs.notes);
  observer.tell(kTraining, 0);
  return fit::add_effect(model, change, runs,
                         {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
