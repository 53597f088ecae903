#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnosis/visible_part.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Smooth functions of one thing that a drift can depend on; no physics in them. They find out
/// whether a residual has structure that no catalogued effect explains, and on what it depends.
struct StructureGroup {
  std::string variable;     ///< "temperature_degc", "temperature_rate", "time_s", ...
  Eigen::MatrixXd columns;  ///< rows x any, neither whitened nor scaled
};

/// Smooths of temperature, of its rate, of their product, of history (lagged temperatures and play
/// operators), of time within each run, and of every further input that varies.
std::vector<StructureGroup> structure_groups(const series::Rows& rows);

/// Smooth structure behind a model: orthonormal whitened columns, group by group and together.
struct VisibleStructure {
  std::vector<std::string> variables;
  std::vector<Eigen::MatrixXd> groups;
  Eigen::MatrixXd all;
};
VisibleStructure visible_structure(const series::Rows& rows, const Residualizer& residualizer);

}  // namespace fogcomp::diagnosis
