#include "workflow/add.hpp"

#include "model/model_file.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {

fit::Addition add(const AddRequest& request, const Observer& observer) {
  model::Model model = model::load_model(request.model);
  const fit::EffectChange change = request.expression
                                       ? fit::change_expression(model.terms, *request.expression)
                                       : fit::change_effects(model.terms, request.effects);
  const recording::ReadOptions reading = reading_for(model, request.reading, observer);
  if (!reading.columns.empty()) model.columns = reading.columns;
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
