#include "workflow/add.hpp"

#include "model/model_file.hpp"

namespace fogcomp::workflow {

Addition add(const AddRequest& request, const Observer& observer) {
  const Model model = load_model(request.model);
  const EffectChange change = request.expression
                                  ? change_expression(model.terms, *request.expression)
                                  : change_effects(model.terms, request.effects);
  ReadOptions reading = observer.heard(request.reading);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  const TrainingRuns training = read_training_runs(request.runs, reading, model.average_s);
  const Holdouts judges = read_holdouts(request.hold_outs, reading, model.average_s, training.runs);
  observer.say(training.notes);
  observer.say(judges.notes);
  observer.tell(kTraining, 0);
  return add_effect(model, change, training, judges.runs,
                    {request.run_offsets, request.seed, observer.of_stage(kTraining)});
}

}  // namespace fogcomp::workflow
