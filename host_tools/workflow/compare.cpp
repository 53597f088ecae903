#include "workflow/compare.hpp"

#include <utility>

#include "compare/joined_runs.hpp"
#include "fit/turn_on_bias.hpp"
#include "model/model_file.hpp"
#include "recording/data_hash.hpp"
#include "support/input_error.hpp"
#include "workflow/reading.hpp"

namespace fogcomp::workflow {
namespace {

std::vector<compare::ModelOnRuns> load_models(const CompareRequest& request) {
  std::vector<compare::ModelOnRuns> models;
  for (const std::string& file : request.models) {
    models.push_back({file, model::load_model(file), {}});
    model::Model& model = models.back().model;
    if (request.physics_alone) model.network = model::RealNetwork();
    if (!request.reading.scale_factor && model.scale_factor != models[0].model.scale_factor) {
      throw InputError(file,
                       "has another scale factor than " + models[0].file + "; give --scale-factor");
    }
  }
  return models;
}

// In the rows of the comparison.
compare::TurnOn turn_on_biases(model::Model model, double row_s,
                               const std::vector<compare::RunInBlocks>& runs) {
  model.average_s = row_s;
  return fit::turn_on_biases(model, runs);
}

double row_length_s(const CompareRequest& request, const model::Model& first) {
  return request.average_s.value_or(first.average_s);
}

}  // namespace

std::vector<compare::RunInBlocks> compared_runs(const CompareRequest& request,
                                                const Observer& observer) {
  const model::Model first = model::load_model(request.models.at(0));
  const recording::ReadOptions reading = reading_for(first, request.reading, observer);
  recording::KnownRows known;
  std::vector<compare::RunInBlocks> runs;
  for (std::size_t i = 0; i < request.runs.size(); ++i) {
    const std::string& file = request.runs[i];
    observer.tell("comparing", static_cast<double>(i) / static_cast<double>(request.runs.size()));
    compare::RunInBlocks run = compare::run_in_blocks(recording::read_recording(file, reading),
                                                      row_length_s(request, first));
    const std::string same = known.file_with(run.blocks.recordings[0]);
    if (!same.empty()) {
      observer.say({recording::same_rows_words(run.file, same)});
      continue;
    }
    known.add(run.blocks.recordings[0], run.file);
    runs.push_back(std::move(run));
  }
  std::vector<std::string> notes;
  runs = compare::join_continued(std::move(runs), notes);
  observer.say(notes);
  return runs;
}

std::vector<compare::ModelOnRuns> compare(const CompareRequest& request,
                                          const std::vector<compare::RunInBlocks>& runs,
                                          const Observer& observer) {
  std::vector<compare::ModelOnRuns> models = load_models(request);
  for (const compare::RunInBlocks& run : runs) {
    observer.say(run.notes);
    for (compare::ModelOnRuns& model : models)
      model.runs.push_back(compare::try_model(model.model, run));
  }
  const double row_s = row_length_s(request, models[0].model);
  for (compare::ModelOnRuns& model : models)
    model.turn_on = turn_on_biases(model.model, row_s, runs);
  return models;
}

std::vector<compare::ModelOnRuns> compare(const CompareRequest& request, const Observer& observer) {
  load_models(request);  // errors of a model are reported before a recording is read
  return compare(request, compared_runs(request, observer), observer);
}

}  // namespace fogcomp::workflow
