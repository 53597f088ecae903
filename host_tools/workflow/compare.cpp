#include "workflow/compare.hpp"

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

}  // namespace

std::vector<compare::ModelOnRuns> compare(const CompareRequest& request, const Observer& observer) {
  std::vector<compare::ModelOnRuns> models = load_models(request);
  const double row_s = request.average_s.value_or(models[0].model.average_s);
  const recording::ReadOptions reading = reading_for(models[0].model, request.reading, observer);
  recording::KnownRows known;
  for (std::size_t i = 0; i < request.runs.size(); ++i) {
    const std::string& file = request.runs[i];
    observer.tell("comparing", static_cast<double>(i) / static_cast<double>(request.runs.size()));
    const compare::RunInBlocks run =
        compare::run_in_blocks(recording::read_recording(file, reading), row_s);
    const std::string same = known.file_with(run.rows_hash);
    if (!same.empty()) {
      observer.say({recording::same_rows_words(run.file, same)});
      continue;
    }
    known.add(run.rows_hash, run.file);
    observer.say(run.notes);
    for (compare::ModelOnRuns& model : models)
      model.runs.push_back(compare::try_model(model.model, run));
  }
  return models;
}

}  // namespace fogcomp::workflow
