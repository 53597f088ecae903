#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::simulation {

/// Turns values at the ends of equal steps into means over rows of another length: a row shorter
/// than a step takes its part of the straight line between two values, a longer one the mean over
/// many. A held channel stands at its last value instead (a sensor between two conversions).
class RowMeans {
 public:
  enum class Between { straight, held };

  /// `first`: the values at time 0, one for each channel.
  RowMeans(double step_s, double row_s, std::vector<Between> channels, std::vector<double> first);

  /// Whether the next row reaches beyond the steps known so far: push() first.
  bool needs_step() const;
  /// Values at the end of the next step. Only when needs_step().
  void push(const std::vector<double>& values);
  /// Writes the means over the next row, one for each channel. Only when not needs_step().
  void next_row(double* means);

 private:
  void add_until(double time_s);

  double step_s_;
  double row_s_;
  std::vector<Between> channels_;
  std::vector<double> before_;  ///< values at the start of the current step
  std::vector<double> after_;   ///< and at its end
  std::vector<double> sums_;    ///< integral over the current row so far
  std::size_t steps_ = 0;       ///< pushed so far
  std::size_t rows_ = 0;
  double done_s_ = 0;  ///< integrated up to here
};

}  // namespace fogcomp::simulation
