#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// What is left of a run's drift, in half a sentence.
std::string error_words(const compare::Comparison& comparison);

/// On what the residual depends beyond noise: largest share first, but time last, as anything slow
/// is a function of time.
std::string structure_words(const compare::ModelOnRun& run);

/// What has to be known with the figures, a half sentence each: rows left out, what the board's
/// delay makes of the residual, a noise floor that cannot be right.
std::vector<std::string> remarks(const compare::ModelOnRun& run);

/// A sentence for each run whose bias certainly differs from the first one's: "turn-on bias: b.csv
/// is 0.120 +- 0.012 deg/h above a.csv".
std::vector<Text> turn_on_sentences(const std::vector<compare::TurnOnBias>& turn_on);

/// A sentence for each kind of rows that the model never saw in training.
std::vector<std::string> range_warnings(const compare::Comparison& comparison,
                                        const model::Model& model);

}  // namespace fogcomp::findings
