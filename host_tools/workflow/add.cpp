#include "workflow/add.hpp"

#include "model/catalogue.hpp"

namespace fogcomp::workflow {
namespace {

fit::EffectChange change_of(const AddRequest& request,
                            const std::vector<model::EffectTerm>& terms) {
  if (request.expression) return fit::change_expression(terms, *request.expression);
  if (request.only_cuts) return fit::change_cuts(terms, request.reading.cuts);
  return fit::change_effects(terms, request.effects);
}

}  // namespace

fit::Addition add(const AddRequest& request, const Observer& observer) {
  return add(request, judging_runs(request, {}, observer), observer);
}

fit::Addition add(const AddRequest& request, const runs::Runs& runs, const Observer& observer) {
  model::Model model = model::load_model(request.model);
  observer.say(model::leave_out_events(model.terms));
  fit::EffectChange change = change_of(request, model.terms);
  const std::string read = mask_words(request.reading);
  change.what = request.only_cuts ? read.substr(1) : change.what + read;
  remember_reading(request.reading, model);
  observer.say(runs.notes);
  observer.tell(kTraining, 0);
  return fit::add_effect(model, change, runs,
                         {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
