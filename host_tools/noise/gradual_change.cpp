#include "noise/gradual_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/least_squares.hpp"

namespace fogcomp::noise {
namespace {

double time_before(const series::Rows& rows, Eigen::Index row) {
  const auto at = static_cast<std::size_t>(row);
  return (rows.time_s[at - 1] + rows.time_s[at]) / 2;
}

constexpr double kSlowestChangeS = 480;

// The rows of one recording around a jump.
struct Surroundings {
  Eigen::Index first = 0;
  Eigen::VectorXd away_s;  // since the jump
};

Surroundings surroundings_of(const series::Rows& rows, std::size_t jump) {
  const double jump_s = time_before(rows, static_cast<Eigen::Index>(jump));
  const recording::RowRange run = rows.runs()[rows.run_at(jump)];
  const auto is_near = [&](std::size_t row) {
    return std::abs(rows.time_s[row] - jump_s) <= kSlowestChangeS;
  };
  std::size_t first = jump - 1;
  std::size_t end = jump + 1;
  while (first > run.first && is_near(first - 1)) --first;
  while (end < run.end && is_near(end)) ++end;
  Surroundings near{static_cast<Eigen::Index>(first),
                    Eigen::VectorXd(static_cast<Eigen::Index>(end - first))};
  for (std::size_t row = first; row < end; ++row)
    near.away_s[static_cast<Eigen::Index>(row - first)] = rows.time_s[row] - jump_s;
  return near;
}

constexpr Eigen::Index kColumnsBeside = 5;

// Of those rows: a curve and the two rows next to the jump; the jump; and changes that take a time.
Eigen::MatrixXd changes_near(const Surroundings& near, Eigen::Index jump) {
  constexpr std::array<double, 4> kTakesS{60, 120, 240, kSlowestChangeS};
  constexpr std::array<double, 5> kPlaces{-0.5, -0.25, 0, 0.25, 0.5};
  const Eigen::ArrayXd away_s = near.away_s;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(
      away_s.size(),
      kColumnsBeside + 1 + static_cast<Eigen::Index>(kTakesS.size() * kPlaces.size()));
  for (int power = 0; power < 3; ++power)
    columns.col(power) = (away_s / kSlowestChangeS).pow(power);
  for (const Eigen::Index next : {jump - 1, jump}) columns(next - near.first, 4 + next - jump) = 1;
  columns.col(kColumnsBeside) = (away_s > 0).cast<double>();
  Eigen::Index column = kColumnsBeside;
  for (const double takes_s : kTakesS) {
    for (const double place : kPlaces)
      columns.col(++column) = (0.5 - place + away_s / takes_s).cwiseMax(0).cwiseMin(1);
  }
  return columns;
}

}  // namespace

double gain_of_gradual_change(std::size_t row, const Whitening& whitening, const series::Rows& rows,
                              const Eigen::VectorXd& whitened_residual) {
  const Surroundings near = surroundings_of(rows, row);
  const Eigen::Index count = near.away_s.size();
  const Eigen::MatrixXd plain = changes_near(near, static_cast<Eigen::Index>(row));
  Eigen::MatrixXd of_all_rows = Eigen::MatrixXd::Zero(rows.size(), plain.cols());
  of_all_rows.middleRows(near.first, count) = plain;
  const Eigen::MatrixXd white = whitening.apply(of_all_rows).middleRows(near.first, count);
  const Eigen::MatrixXd beside = orthonormal(white.leftCols(kColumnsBeside));
  const auto left = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
    return columns - beside * (beside.transpose() * columns);
  };
  const Eigen::VectorXd residual = left(whitened_residual.segment(near.first, count));
  const Eigen::MatrixXd changes = left(white.rightCols(white.cols() - kColumnsBeside));
  const Eigen::ArrayXd squares = changes.colwise().squaredNorm().transpose().cwiseMax(1e-300);
  const Eigen::ArrayXd explained = (changes.transpose() * residual).array().square() / squares;
  const double most = explained.maxCoeff();
  const auto freedom = static_cast<double>(std::max<Eigen::Index>(1, count - kColumnsBeside - 1));
  return (most - explained[0]) / std::max(1.0, (residual.squaredNorm() - most) / freedom);
}

}  // namespace fogcomp::noise
