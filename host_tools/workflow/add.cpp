#include "workflow/add.hpp"

#include "model/model_file.hpp"

namespace fogcomp::workflow {

fit::Addition add(const AddRequest& request, const Observer& observer) {
  const model::Model model = model::load_model(request.model);
  const fit::EffectChange change = request.expression
                                       ? fit::change_expression(model.terms, *request.expression)
                                       : fit::change_effects(model.terms, request.effects);
  recording::ReadOptions reading = observer.heard(request.reading);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  const fit::TrainingRuns training =
      fit::read_training_runs(request.runs, reading, model.average_s);
  const fit::Holdouts judges =
      fit::read_holdouts(request.hold_outs, reading, model.average_s, training.runs);
  observer.say(training.notes);
  observer.say(judges.notes);
  observer.tell(kTraining, 0);
  return fit::add_effect(model, change, training, judges.runs,
                         {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
