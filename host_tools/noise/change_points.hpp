#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "noise/whitening.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// A jump of the residual between two rows of one recording that lasts to the recording's end.
struct ChangePoint {
  Eigen::Index row = 0;    ///< first row after the jump
  Eigen::Index first = 0;  ///< first and last row that may contain it: rows with a chi^2
  Eigen::Index last = 0;   ///< within 9 of the best, and the row before, which may contain a part
  /// Rows around it at each of which a jump explains at least half as much.
  recording::RowRange peak;
  double time_s = 0;           ///< between the row before and `row`
  double time_sigma_s = 0;     ///< one standard deviation
  double size_dph = 0;         ///< after minus before
  double size_sigma_dph = 0;   ///< one standard deviation
  double chi_square = 0;       ///< decrease of the sum of squares by the jump
  double chi_square_left = 0;  ///< reduced chi^2 with the jump: 1 for noise alone
};

/// The jump that lowers the whitened sum of squares most, anywhere but within ten rows of a
/// recording's ends; none if no position is determined beside the columns. O(rows).
/// `whitened_residual`: per row. `whitened_columns`: rows x any number, the model, which is fitted
/// again with the jump (projected out). Both are whitened by `whitening` of the same rows; rows of
/// weight 0 are skipped, and those in `except`, one value per row. The caller decides whether a
/// jump is significant: in flicker noise alone the best has a chi^2 of 10 to 30.
std::optional<ChangePoint> find_change_point(const Whitening& whitening, const series::Rows& rows,
                                             const Eigen::VectorXd& whitened_residual,
                                             const Eigen::MatrixXd& whitened_columns,
                                             const std::vector<bool>& except);

/// How much more a change that takes one to eight minutes explains than a jump before `row`, within
/// eight minutes of it and beside a curve: the further decrease of the sum of squares, in units of
/// what is left there; 0 if no more. The two rows next to the jump, one of which it divides, do not
/// count. `whitened_residual`: one value per row, with the jump in it.
double gain_of_gradual_change(std::size_t row, const Whitening& whitening, const series::Rows& rows,
                              const Eigen::VectorXd& whitened_residual);

}  // namespace fogcomp::noise
