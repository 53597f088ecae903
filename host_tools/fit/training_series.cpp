#include "fit/training_series.hpp"

namespace fogcomp::fit {

TrainingSeries::TrainingSeries(const model::Model& model, const TrainingRuns& training)
    : model_(model), series_(model_), known_(series_) {
  for (const compare::RunInBlocks& run : training.runs) series_.add(run.blocks);
}

}  // namespace fogcomp::fit
