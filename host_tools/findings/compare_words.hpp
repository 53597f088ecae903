#pragma once

#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "findings/text.hpp"

namespace fogcomp::findings {

/// The remaining drift of a run, as part of a sentence.
std::string error_words(const compare::Comparison& comparison);

/// Variables on which the residual depends beyond noise: largest share first, but time last,
/// because everything slow depends on time.
std::string structure_words(const compare::ModelOnRun& run);

/// How often the run lies within what the model promises, as a part of a sentence.
std::string band_words(const compare::PredictiveBand& band);

/// Remarks about the values, as parts of sentences: rows left out, effect of the board's delay, an
/// implausible noise floor.
std::vector<std::string> remarks(const compare::ModelOnRun& run);

/// One sentence for each run whose bias certainly differs from the first one's: "turn-on bias:
/// b.csv is 0.120 +- 0.012 deg/h above a.csv".
std::vector<Text> turn_on_sentences(const compare::TurnOn& turn_on);

/// One sentence for each kind of rows outside the trained ranges.
std::vector<std::string> range_warnings(const compare::Comparison& comparison,
                                        const model::Model& model);

}  // namespace fogcomp::findings
