#pragma once

#include <cstddef>
#include <vector>

#include "noise/noise_model.hpp"
#include "recording/segments.hpp"

namespace fogcomp::compare {

/// The residual of a run and what is known of its noise. All vectors have a value per row.
struct ResidualRows {
  std::vector<double> residual_dph;
  std::vector<double> time_s;
  std::vector<recording::RowRange> stretches;  ///< rows without a gap
  noise::NoiseModel noise;  ///< from the run's soaks: how much its rows go together
};

/// Whether means of the residual over classes of rows differ by more than its noise. The covariance
/// of the means follows from the noise model, row by row, so that slow noise does not pass for
/// dependence; it is raised where the rows scatter more within their classes than the model says.
struct ClassTest {
  /// Variance of the class means, noise taken off, (deg/h)^2: what a model of this variable alone
  /// could still remove.
  double variance_dph2 = 0;
  /// Standard score of chi^2 of the class means (Wilson & Hilferty), about N(0,1) for noise alone.
  double score = 0;
  /// The score is above 5. With a noise model taken from the run's own soaks, itself uncertain, the
  /// white and slow noise of 300 simulated runs reached that 1, 0 and 5 times over temperature,
  /// rate and history, and 20 times over time.
  bool structured() const;
};

struct ResidualBin {
  double at = 0;  ///< mean of the variable
  double mean_dph = 0;
  double sigma_dph = 0;  ///< standard error of the mean
  std::size_t rows = 0;
};

/// The residual over one variable.
struct Dependence {
  std::vector<ResidualBin> bins;  ///< of equal width, those with at least 5 rows
  ClassTest test;
};

/// `bins`: how many over the variable's range. Noise too slow for the soaks to show it, as the
/// longest wander of a day, does count as dependence on time.
Dependence dependence_on(const std::vector<double>& variable, const ResidualRows& rows,
                         std::size_t bins);

struct LoopBin {
  double at_degc = 0;
  double heating_dph = 0;  ///< mean of the residual where the last movement was upwards
  double cooling_dph = 0;
  double sigma_dph = 0;  ///< of their difference
  double width_dph() const { return heating_dph - cooling_dph; }
};

/// The residual's dependence on history: heating against cooling branch at equal temperature.
struct Loop {
  std::vector<LoopBin> bins;  ///< those with at least 5 rows on each branch
  ClassTest test;             ///< of the branches' difference within the bins

  /// Where |heating - cooling| is widest; nullptr without bins.
  const LoopBin* widest() const;
};

/// Whether the mean of all rows differs from 0.
ClassTest test_of_mean(const ResidualRows& rows);
/// Standard error of that mean, deg/h.
double sigma_of_mean(const ResidualRows& rows);

/// By the branches() of the temperature.
Loop loop_over(const std::vector<double>& temperature_degc, const ResidualRows& rows,
               std::size_t bins);

}  // namespace fogcomp::compare
