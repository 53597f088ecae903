#pragma once

#include <Eigen/Core>

#include "judge/mode_bands.hpp"
#include "judge/rows.hpp"

namespace fogcomp::judge {

/// Rows, and what turns columns of them into the cosine modes in which a judge compares them.
class ModeSpace {
 public:
  explicit ModeSpace(Rows rows);

  const Rows& rows() const { return rows_; }
  const ModeBands& bands() const { return bands_; }

  /// Modes of an effect's columns (rows x any number), each of which has an rms of 1 about its
  /// mean: only as many as columns have that are as smooth as drift (ModeBands::needed()).
  Eigen::MatrixXd of_effect(const Eigen::MatrixXd& columns) const;

 private:
  Rows rows_;
  ModeBands bands_;
};

/// Root of the mean square of a column about its mean.
double rms_about_mean(const Eigen::VectorXd& column);

}  // namespace fogcomp::judge
