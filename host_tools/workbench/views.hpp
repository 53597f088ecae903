#pragma once

#include <map>
#include <string>
#include <vector>

#include "compare/model_on_runs.hpp"
#include "model/model.hpp"
#include "support/json.hpp"

/// What the page shows: a model, and a recording under it.
namespace fogcomp::workbench {

/// A model: its file ("text"), options of its rows, and its terms: coefficients and shape
/// parameters with standard deviations in their natural units, and the bounds of each shape
/// parameter.
Json model_json(const model::Model& model);

/// The sentences of `compare`, the segments to be shaded, and the columns that the residual can be
/// drawn over, with the labels of their axes.
Json run_json(const compare::ModelOnRun& run, const model::Model& model);

/// Values of each row by name, in s, degC, degC/min, deg/h or the unit of the input; the marks
/// "outlier", "branch" and "gap_before" (1 after a gap and for the first row, else 0).
using Columns = std::map<std::string, std::vector<double>>;
Columns columns_of(const compare::Comparison& comparison);

}  // namespace fogcomp::workbench
