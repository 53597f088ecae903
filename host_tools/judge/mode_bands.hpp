#pragma once

#include <Eigen/Core>
#include <vector>

#include "recording/row_range.hpp"

namespace fogcomp::judge {

/// Bands of cosine modes of evenly spaced rows, in each of which the spectrum of noise hardly
/// changes: sums of products over a band replace its rows, and a likelihood takes microseconds.
class ModeBands {
 public:
  /// `stretches`: evenly spaced rows, apart. The mean of a stretch is at half the angle of its
  /// first mode, where a random walk has its variance within a fifth.
  ModeBands(const std::vector<recording::RowRange>& stretches, double per_octave);

  Eigen::Index size() const { return angle_.size(); }
  const Eigen::ArrayXd& angle() const { return angle_; }  ///< per row, geometric mean of each band
  const Eigen::ArrayXd& count() const { return count_; }  ///< modes of each band
  const std::vector<Eigen::Index>& first() const { return first_; }  ///< mode of each, and the end

  /// Cosine modes of columns of rows, band by band.
  Eigen::MatrixXd modes(const Eigen::MatrixXd& columns) const;
  /// How many modes columns have that are as smooth as drift: those of whole bands, beyond which
  /// less than 1e-5 of the size of each is left.
  Eigen::Index needed(const Eigen::MatrixXd& modes) const;
  /// Sums of products of such modes over each band: left x right columns, column by column, in a
  /// column for each band. Modes may end with a band: the others are 0.
  Eigen::MatrixXd products(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) const;

  /// Variance of a mode relative to white noise: `flicker` and `walk` at an angle of one per row.
  Eigen::ArrayXd noise_density(double flicker, double walk) const;
  /// Mean over the fastest quarter of the modes, from sums over each band.
  double mean_of_fast_modes(const Eigen::VectorXd& sums) const;

 private:
  std::vector<recording::RowRange> stretches_;
  std::vector<Eigen::Index> place_;  // of each mode, stretch by stretch
  std::vector<Eigen::Index> first_;  // mode of each band, and the end
  Eigen::ArrayXd angle_;
  Eigen::ArrayXd count_;
};

/// The largest levels of slow noise that are tried, as noise_density() takes them: they exceed the
/// white noise in nearly all modes.
inline constexpr double kMostFlicker = 16;
inline constexpr double kMostWalk = 4;

/// Products summed over the bands with these weights: a matrix of `rows` rows.
Eigen::MatrixXd weighted(const Eigen::MatrixXd& products, const Eigen::VectorXd& weights,
                         Eigen::Index rows);

}  // namespace fogcomp::judge
