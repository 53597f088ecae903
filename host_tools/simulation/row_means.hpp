#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::simulation {

/// Converts values at the ends of equal steps to means over rows of another length: a row shorter
/// than a step uses linear interpolation, a longer one the mean over many. A held channel keeps its
/// last value (a sensor between two conversions).
class RowMeans {
 public:
  enum class Between { straight, held };

  /// `first`: values at time 0, one per channel.
  RowMeans(double step_s, double row_s, std::vector<Between> channels, std::vector<double> first);

  /// Whether the next row extends beyond the known steps: call push() first.
  bool needs_step() const;
  /// Adds the values at the end of the next step. Requires needs_step().
  void push(const std::vector<double>& values);
  /// Writes the means over the next row, one per channel. Requires !needs_step().
  void next_row(double* means);

 private:
  void add_until(double time_s);

  double step_s_;
  double row_s_;
  std::vector<Between> channels_;
  std::vector<double> before_;  ///< values at the start of the current step
  std::vector<double> after_;   ///< and at its end
  std::vector<double> sums_;    ///< integral over the present row so far
  std::size_t steps_ = 0;       ///< pushed so far
  std::size_t rows_ = 0;
  double done_s_ = 0;  ///< end of the integrated time
};

}  // namespace fogcomp::simulation
