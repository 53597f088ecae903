#include "findings/compared_models.hpp"

#include "findings/labels.hpp"
#include "findings/run_plots.hpp"

namespace fogcomp::findings {

const compare::Comparison& on_run(const compare::ModelOnRuns& model, std::size_t run) {
  return model.runs[run].comparison;
}

std::vector<Text> labels(const Models& models, const Text& alone) {
  if (models.size() == 1) return {alone};
  std::vector<std::string> files;
  for (const compare::ModelOnRuns* model : models) files.push_back(model->file);
  std::vector<Text> labels;
  for (const std::string& name : short_names(files)) labels.push_back(verbatim(name));
  return labels;
}

std::string residual_colour(std::size_t model) {
  return model == 0 ? "residual" : part_colour(model);
}

Look look_of(std::size_t model) {
  return model == 0 ? Look::line : Look::faint;
}

}  // namespace fogcomp::findings
