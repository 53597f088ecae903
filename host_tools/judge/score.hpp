#pragma once

#include <Eigen/Core>
#include <cmath>

#include "support/evidence.hpp"

namespace fogcomp::judge {

/// What happens by chance as often as kFalseAlarm: as the logarithm of a ratio of probability
/// densities (Markov's inequality: its mean is 1), and in standard deviations.
inline const double kGain = -std::log(kFalseAlarm);
inline constexpr double kSigmas = 2.33;

/// What a model foretells of rows: each from those that it may know and the rows before it.
struct Foretold {
  Eigen::VectorXd mean_dph;
  Eigen::VectorXd variance;  ///< (deg/h)^2; 0: the row is not foretold
};

/// The sum of squares of what coefficients leave of rows that they do not know, in units of the
/// noise, and what their uncertainty makes of it.
struct Promise {
  double squares = 0;
  double expected = 0;
  double variance = 0;  ///< of the sum

  /// The error is larger than it should be.
  bool is_broken() const;
  void add(const Promise& other);
};

/// How much better one model foretells rows than another.
struct Score {
  double gain = 0;  ///< ln of the ratio of the probability densities that they gave to the rows
  /// Standard deviation of the gain if, of the two, the one that is surer of a row is right (after
  /// Cox 1961).
  double standard_error = 0;

  bool improves() const { return gain >= kGain; }
  bool harms() const { return gain <= -kGain; }
};

/// Of the rows that both foretell.
Score score(const Eigen::VectorXd& measured_dph, const Foretold& before, const Foretold& after);

}  // namespace fogcomp::judge
