#include "workflow/diagnose.hpp"

#include "model/effect_list.hpp"
#include "model/model_file.hpp"

namespace fogcomp::workflow {
namespace {

// Expressions that are to compete with the catalogue.
std::vector<EffectTerm> offered(const DiagnoseRequest& request, const Model& model) {
  std::vector<EffectTerm> terms = model.terms;
  for (const std::string& definition : request.expressions) add_expression(terms, definition);
  return {terms.begin() + static_cast<std::ptrdiff_t>(model.terms.size()), terms.end()};
}

}  // namespace

DiagnoseOutcome diagnose(const DiagnoseRequest& request, const Observer& observer) {
  auto own = std::make_unique<Model>(load_model(request.model));
  own->average_s = request.average_s.value_or(own->average_s);
  const Model& model = *own;
  DiagnoseOutcome outcome{std::move(own), DiagnosisData(model, offered(request, model)), {}, {}};
  ReadOptions reading = observer.heard(request.reading);
  reading.model_scale_factor = model.scale_factor;
  reading.model_limits = model.limits;
  BoardError as_given;
  std::vector<std::string> notes;
  for (const std::string& file : request.runs) {
    const RunInBlocks run = run_in_blocks(read_recording(file, reading), model.average_s);
    const std::string same = outcome.data.add(run);
    if (!same.empty()) {
      observer.say({same_rows_words(file, same)});
      continue;
    }
    notes.insert(notes.end(), run.notes.begin(), run.notes.end());
    as_given.add(board_error(model, run, compare_with(model, run)));
    outcome.runs.push_back(file);
  }
  DiagnosisSettings settings;
  settings.seed = request.seed;
  settings.progress = observer.of_stage("diagnosing");
  if (request.at_rest) {
    settings.noise =
        noise_of_static(model, read_recording(*request.at_rest, reading), outcome.data);
  }
  outcome.ladder = walk_ladder(model, outcome.data, request.max_effects, settings);
  outcome.ladder.first.as_given = as_given;
  observer.say(notes);
  return outcome;
}

}  // namespace fogcomp::workflow
