#include "workflow/diagnose.hpp"

#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {
namespace {

// Expressions that are to compete with the catalogue.
std::vector<model::EffectTerm> offered(const DiagnoseRequest& request, const model::Model& model) {
  std::vector<model::EffectTerm> terms = model.terms;
  for (const std::string& definition : request.expressions)
    model::add_expression(terms, definition);
  return {terms.begin() + static_cast<std::ptrdiff_t>(model.terms.size()), terms.end()};
}

}  // namespace

DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer) {
  auto own = std::make_unique<model::Model>(model::load_model(request.model));
  own->average_s = request.average_s.value_or(own->average_s);
  const model::Model& model = *own;
  DiagnoseOutcome outcome{
      std::move(own), diagnosis::DiagnosisData(model, offered(request, model)), {}, {}, {}};
  const recording::ReadOptions reading = reading_for(model, request.reading, observer);
  const fit::TrainingRuns training =
      fit::read_training_runs(request.runs, reading, model.average_s);
  observer.say(training.notes);
  compare::BoardError as_given;
  for (const compare::RunInBlocks& run : training.runs) {
    outcome.data.add(run);
    as_given.add(compare::board_error(model, run, compare::compare_with(model, run)));
    outcome.runs.push_back(run.file);
  }
  diagnosis::DiagnosisSettings settings;
  settings.seed = request.seed;
  settings.progress = observer.of_stage("diagnosing");
  if (request.at_rest) {
    settings.noise = diagnosis::noise_of_static(
        model, recording::read_recording(*request.at_rest, reading), outcome.data);
  }
  outcome.ladder = diagnosis::walk_ladder(model, outcome.data, request.max_effects, settings);
  outcome.ladder.first.as_given = as_given;
  outcome.next =
      diagnosis::find_next_step(model, outcome.ladder.first, outcome.data, training, settings);
  return outcome;
}

}  // namespace fogcomp::workflow
