#include "workflow/diagnose.hpp"

#include "model/effect_list.hpp"
#include "model/model_file.hpp"

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
  const model::Model model = model::load_model(request.model);
  auto in_rows = std::make_unique<model::Model>(model);
  in_rows->average_s = request.average_s.value_or(model.average_s);
  recording::ReadOptions reading = observer.heard(request.reading);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  diagnosis::JudgingRuns judging{fit::read_training_runs(request.runs, reading, model.average_s),
                                 {}};
  fit::Holdouts holdouts =
      fit::read_holdouts(request.hold_outs, reading, model.average_s, judging.training.runs);
  observer.say(judging.training.notes);
  observer.say(holdouts.notes);
  judging.holdouts = std::move(holdouts.runs);

  diagnosis::DiagnosisData data(*in_rows, offered(request, model));
  DiagnoseOutcome outcome{std::move(in_rows), std::move(data), {}, {}};
  compare::BoardError as_given;
  const auto add = [&](const compare::RunInBlocks& run) {
    outcome.data.add(run);
    as_given.add(
        compare::board_error(*outcome.model, run, compare::compare_with(*outcome.model, run)));
    outcome.runs.push_back(run.file);
  };
  if (outcome.model->average_s == model.average_s) {
    for (const compare::RunInBlocks& run : judging.training.runs) add(run);
  } else {
    const fit::TrainingRuns in_other_rows =
        fit::read_training_runs(request.runs, reading, outcome.model->average_s);
    for (const compare::RunInBlocks& run : in_other_rows.runs) add(run);
  }
  diagnosis::DiagnosisSettings settings;
  settings.seed = request.seed;
  settings.progress = observer.of_stage("diagnosing");
  if (request.at_rest) {
    settings.noise = diagnosis::noise_of_static(
        *outcome.model, recording::read_recording(*request.at_rest, reading), outcome.data);
  }
  outcome.ladder =
      diagnosis::walk_ladder(model, outcome.data, judging, request.max_steps, settings);
  outcome.ladder.first.as_given = as_given;
  return outcome;
}

}  // namespace fogcomp::workflow
