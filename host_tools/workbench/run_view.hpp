#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "support/json.hpp"

/// What the page shows of a recording under a model.
namespace fogcomp::workbench {

/// The sentences of `compare`, the segments to be shaded, and the columns that the residual can be
/// drawn over, with the labels of their axes.
Json run_json(const compare::ModelOnRun& run, const model::Model& model);

/// Values of each row by name, in s, degC, degC/min, deg/h or the unit of the input; the marks
/// "outlier", "branch" and "gap_before" (1 after a gap and for the first row, else 0).
using Columns = std::map<std::string, std::vector<double>>;
Columns columns_of(const compare::Comparison& comparison);

}  // namespace fogcomp::workbench
