#include "workflow/compare.hpp"

#include "fit/turn_on_bias.hpp"
#include "model/model_file.hpp"
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
                               const std::vector<runs::Run>& runs) {
  model.average_s = row_s;
  return fit::turn_on_biases(model, runs);
}

double row_length_s(const CompareRequest& request, const model::Model& first) {
  return request.average_s.value_or(first.average_s);
}

}  // namespace

runs::Runs compared_runs(const CompareRequest& request, const Observer& observer) {
  const model::Model first = model::load_model(request.models.at(0));
  return runs::read_holdouts(request.runs, reading_for(first, request.reading, observer),
                             {row_length_s(request, first)});
}

std::vector<compare::ModelOnRuns> compare(const CompareRequest& request, const runs::Runs& runs,
                                          const Observer& observer) {
  std::vector<compare::ModelOnRuns> models = load_models(request);
  observer.say(runs.notes);
  const double row_s = row_length_s(request, models[0].model);
  double done = 0;
  for (const runs::Run& run : runs.holdouts) {
    observer.tell("comparing", done++ / static_cast<double>(runs.holdouts.size()));
    for (compare::ModelOnRuns& model : models)
      model.runs.push_back(compare::try_model(model.model, run, row_s));
  }
  for (compare::ModelOnRuns& model : models)
    model.turn_on = turn_on_biases(model.model, row_s, runs.holdouts);
  return models;
}

std::vector<compare::ModelOnRuns> compare(const CompareRequest& request, const Observer& observer) {
  load_models(request);  // errors of a model are reported before a recording is read
  return compare(request, compared_runs(request, observer), observer);
}

}  // namespace fogcomp::workflow
