#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::diagnosis {

/// A bias that switches between two levels at random times (random telegraph noise).
struct TwoLevels {
  double height_dph = 0;  ///< of the upper level above the lower
  double dwell_s = 0;     ///< mean duration of a level
  /// ln of the odds against a Gaussian random process, whose spectrum can be the same, so that a
  /// noise model cannot tell them apart. 0 unless the bias returns: two visits to a level begin and
  /// end within a stretch and last four rows, or one change up and one down have an eighth of their
  /// stretch on either side.
  double log_odds = 0;
  double chi2_drop = 0;  ///< fall of the stretches' chi^2 from white noise alone
};

/// Analyses quiet stretches of a residual, deg/h, one value per row, without drift (NaN: a row that
/// does not count): the best of a grid of heights (0.5 to 8 times `white_dph`, the white noise of a
/// row) and dwell times (8 rows to half of the longest stretch), against the best Gauss-Markov
/// process of the same grid. Every stretch has its own mean.
TwoLevels find_two_levels(const std::vector<Eigen::VectorXd>& stretches, double white_dph,
                          double row_s);

}  // namespace fogcomp::diagnosis
