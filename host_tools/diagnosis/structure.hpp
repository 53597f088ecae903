#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "diagnosis/visible_part.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Smooth functions of one variable of the drift, without physics. They show whether a residual has
/// structure that no catalogued effect explains, and on which variable it depends.
struct StructureGroup {
  std::string variable;     ///< "temperature_degc", "temperature_rate", "time_s", ...
  Eigen::MatrixXd columns;  ///< rows x any, neither whitened nor scaled
};

/// What follows the temperature late, or with play.
struct TemperatureHistory {
  double parameter = 0;  ///< time constant, s, of the lag; or radius, degC, of the play operator
  bool is_play = false;
};
inline constexpr std::array<TemperatureHistory, 8> kTemperatureHistories{
    {{240}, {960}, {3840}, {15360}, {2, true}, {5, true}, {10, true}, {20, true}}};

/// How far the temperature of each row is from that, degC.
Eigen::VectorXd temperature_beyond(const series::Rows& rows, const Eigen::VectorXd& temperature,
                                   const TemperatureHistory& history);

/// Smooth functions of the time within each run, rows x any.
Eigen::MatrixXd smooths_in_time(const series::Rows& rows);

/// Smooth functions of temperature, its rate, their product, history (lagged temperatures and play
/// operators), time within each run, and every further input that varies.
std::vector<StructureGroup> structure_groups(const series::Rows& rows);

/// Smooth structure with the model projected out: orthonormal whitened columns, by group and
/// together.
struct VisibleStructure {
  std::vector<std::string> variables;
  std::vector<Eigen::MatrixXf> groups;
  Eigen::MatrixXf all;
  std::vector<StructureGroup> raw;  ///< all groups, as they are
};
VisibleStructure visible_structure(const series::Rows& rows, const Residualizer& residualizer);

}  // namespace fogcomp::diagnosis
