#include "diagnosis/structure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/thermal/play.hpp"
#include "model/input_value.hpp"
#include "series/rows.hpp"
#include "support/decompositions.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr int kTemperatureKnots = 8;
constexpr int kRateKnots = 6;
constexpr int kTimeKnots = 8;  // per run
constexpr int kMaxTimeKnots = 32;

Eigen::VectorXd column_of(
    const series::Rows& rows,
    const std::function<double(const fog::Signals<model::RealNumbers>&)>& value) {
  Eigen::VectorXd column(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    column[i] = value(rows.signals[static_cast<std::size_t>(i)]);
  }
  return column;
}

// Cubic B-splines over the range of x with equidistant knots: smooth, local, with sum 1.
Eigen::MatrixXd smooths(const Eigen::VectorXd& x, int knots) {
  const double min = x.minCoeff();
  const double step = (x.maxCoeff() - min) / (knots - 1);
  Eigen::MatrixXd columns(x.size(), step > 0 ? knots : 0);
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    columns.col(k) = x.unaryExpr([&](double value) {
      const double u = std::abs((value - min) / step - static_cast<double>(k));
      if (u >= 2) return 0.0;
      return u < 1 ? 2.0 / 3 - u * u + u * u * u / 2 : std::pow(2 - u, 3) / 6;
    });
  }
  return columns;
}

Eigen::VectorXd beyond_play(const series::Rows& rows, const Eigen::VectorXd& x, double radius) {
  fog::Play<model::RealNumbers> play(radius);
  Eigen::VectorXd beyond(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (rows.starts_run(static_cast<std::size_t>(i))) {
      play = fog::Play<model::RealNumbers>(radius);
      play.start(x[i]);
    }
    beyond[i] = play.step(x[i]);
  }
  return beyond;
}

}  // namespace

Eigen::MatrixXd smooths_in_time(const series::Rows& rows) {
  const auto runs = static_cast<int>(rows.run_starts.size());
  const int knots = std::clamp(kMaxTimeKnots / runs, 3, kTimeKnots);
  std::vector<Eigen::MatrixXd> parts;
  for (const recording::RowRange& run : rows.runs()) {
    const auto first = static_cast<Eigen::Index>(run.first);
    const auto count = static_cast<Eigen::Index>(run.size());
    const Eigen::VectorXd time = Eigen::Map<const Eigen::VectorXd>(&rows.time_s[run.first], count);
    Eigen::MatrixXd here = smooths(time, knots);
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(rows.size(), here.cols());
    part.middleRows(first, count) = here;
    parts.push_back(std::move(part));
  }
  return side_by_side(parts, rows.size());
}

Eigen::VectorXd temperature_beyond(const series::Rows& rows, const Eigen::VectorXd& temperature,
                                   const TemperatureHistory& history) {
  if (history.is_play) return beyond_play(rows, temperature, history.parameter);
  return temperature - series::first_order_lag(rows, temperature, history.parameter);
}

std::vector<StructureGroup> structure_groups(const series::Rows& rows) {
  const Eigen::VectorXd temperature = column_of(rows, [](const auto& s) { return s.temperature; });
  const Eigen::VectorXd rate = column_of(rows, [](const auto& s) { return s.temperature_rate; });
  std::vector<StructureGroup> groups;
  groups.push_back({"temperature_degc", smooths(temperature, kTemperatureKnots)});
  groups.push_back({"temperature_rate", smooths(rate, kRateKnots)});
  // How the drift depends on the rate may vary with temperature as freely as the drift itself.
  const Eigen::MatrixXd product = smooths(temperature, kTemperatureKnots);
  groups.push_back(
      {"temperature_degc x temperature_rate",
       side_by_side({rate.asDiagonal() * product, rate.cwiseAbs2().cwiseProduct(temperature)},
                    rows.size())});
  std::vector<Eigen::MatrixXd> history;
  for (const TemperatureHistory& each : kTemperatureHistories) {
    history.push_back(temperature_beyond(rows, temperature, each));
  }
  groups.push_back({"temperature history", side_by_side(history, rows.size())});
  groups.push_back({"time_s", smooths_in_time(rows)});

  for (std::size_t i = static_cast<std::size_t>(fog::Input::input_rate); i < fog::kInputs; ++i) {
    const fog::InputDescription& input = fog::kInputTable[i];
    const Eigen::VectorXd values =
        column_of(rows, [&](const auto& s) { return model::optional_input(input.input, s.block); });
    if (!(values.maxCoeff() > values.minCoeff())) continue;
    const Eigen::VectorXd x = values.array() - values.mean();
    groups.push_back(
        {input.column, side_by_side({x, x.cwiseAbs2(), x.cwiseProduct(temperature)}, rows.size())});
  }
  return groups;
}

namespace {

// Orthonormal directions of the columns that are not practically invisible.
Eigen::MatrixXf principal(const Eigen::MatrixXd& columns) {
  constexpr double kMin = 1e-3;  // norm relative to a unit column
  const SymmetricEigen eigen = symmetric_eigen(gram(columns));
  Eigen::Index kept = 0;
  while (kept < columns.cols() && eigen.values[columns.cols() - 1 - kept] > kMin) ++kept;
  const Eigen::MatrixXd directions = eigen.vectors.rightCols(kept);
  const Eigen::VectorXd scale = eigen.values.tail(kept).cwiseSqrt().cwiseInverse();
  return (columns * directions * scale.asDiagonal()).cast<float>();
}

}  // namespace

VisibleStructure visible_structure(const series::Rows& rows, const Residualizer& residualizer) {
  VisibleStructure structure;
  std::vector<Eigen::MatrixXd> parts;
  structure.raw = structure_groups(rows);
  for (const StructureGroup& group : structure.raw) {
    const VisiblePart part = residualizer(group.columns);
    Eigen::MatrixXd kept(part.columns.rows(), part.columns.cols());
    Eigen::Index count = 0;
    for (Eigen::Index i = 0; i < part.columns.cols(); ++i) {
      constexpr double kVisibleColumn = 0.01;
      if (part.visible[i] > kVisibleColumn) kept.col(count++) = part.columns.col(i).normalized();
    }
    if (count == 0) continue;
    structure.variables.push_back(group.variable);
    structure.groups.push_back(principal(kept.leftCols(count)));
    parts.push_back(kept.leftCols(count));
  }
  structure.all = principal(side_by_side(parts, residualizer.residual().size()));
  return structure;
}

}  // namespace fogcomp::diagnosis
