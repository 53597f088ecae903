#include "workflow/compare.hpp"

#include "model/model_file.hpp"
#include "recording/data_hash.hpp"
#include "support/input_error.hpp"

namespace fogcomp::workflow {
namespace {

std::vector<ModelOnRuns> load_models(const CompareRequest& request) {
  std::vector<ModelOnRuns> models;
  for (const std::string& file : request.models) {
    models.push_back({file, load_model(file), {}});
    Model& model = models.back().model;
    if (request.physics_alone) model.network = RealNetwork();
    if (!request.reading.scale_factor && model.scale_factor != models[0].model.scale_factor) {
      throw InputError(file,
                       "has another scale factor than " + models[0].file + "; give --scale-factor");
    }
  }
  return models;
}

}  // namespace

std::vector<ModelOnRuns> compare(const CompareRequest& request, const Observer& observer) {
  std::vector<ModelOnRuns> models = load_models(request);
  const double row_s = request.average_s.value_or(models[0].model.average_s);
  ReadOptions reading = observer.heard(request.reading);
  reading.model_scale_factor = models[0].model.scale_factor;
  reading.model_limits = models[0].model.limits;
  KnownRows known;
  for (std::size_t i = 0; i < request.runs.size(); ++i) {
    const std::string& file = request.runs[i];
    observer.tell("comparing", static_cast<double>(i) / static_cast<double>(request.runs.size()));
    const RunInBlocks run = run_in_blocks(read_recording(file, reading), row_s);
    const std::string same = known.file_with(run.rows_hash);
    if (!same.empty()) {
      observer.say({same_rows_words(run.file, same)});
      continue;
    }
    known.add(run.rows_hash, run.file);
    observer.say(run.notes);
    for (ModelOnRuns& model : models) model.runs.push_back(try_model(model.model, run));
  }
  return models;
}

}  // namespace fogcomp::workflow
