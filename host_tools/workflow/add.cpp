#include "workflow/add.hpp"

namespace fogcomp::workflow {

fit::Addition add(const AddRequest& request, const Observer& observer) {
  return add(request, judging_runs(request, {}, observer), observer);
}

fit::Addition add(const AddRequest& request, const runs::Runs& runs, const Observer& observer) {
  model::Model model = model::load_model(request.model);
  fit::EffectChange change = request.expression
                                 ? fit::change_expression(model.terms, *request.expression)
                                 : fit::change_effects(model.terms, request.effects);
  change.what += mask_words(request.reading);
  if (!request.reading.columns.empty()) model.columns = request.reading.columns;
  observer.say(runs.notes);
  observer.tell(kTraining, 0);
  return fit::add_effect(model, change, runs,
                         {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
