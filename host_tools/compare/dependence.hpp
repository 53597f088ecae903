#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "noise/noise_model.hpp"
#include "recording/segments.hpp"

namespace fogcomp::compare {

enum class Branch : std::uint8_t { heating, cooling, none };

/// The branch of each row: direction in which the temperature last moved by more than 2 % of its
/// range (at least 0.5 degC). A soak belongs to the branch of the ramp before it; before the first
/// movement a row has none.
std::vector<Branch> branches(const std::vector<double>& temperature_degc);

/// The residual of a run and its noise. All vectors have one value per row.
struct ResidualRows {
  std::vector<double> residual_dph;
  std::vector<double> time_s;
  std::vector<recording::RowRange> stretches;  ///< rows without a gap
  noise::NoiseModel noise;  ///< from the run's soaks, with its correlation over time
};

/// Test whether means of the residual over classes of rows differ by more than noise. The
/// covariance of the means follows from the noise model, row by row, so that slow noise does not
/// count as a dependence; it is increased if the rows scatter more within their classes than the
/// model predicts.
struct ClassTest {
  /// Variance of the class means without noise, (deg/h)^2: what a model of this variable alone
  /// could still remove.
  double variance_dph2 = 0;
  /// Standard score of chi^2 of the class means (Wilson & Hilferty), about N(0,1) for noise alone.
  double score = 0;
  /// Score > 5. With a noise model from the run's own soaks, which is uncertain, white and slow
  /// noise of 300 simulated runs reached that 1, 0 and 5 times for temperature, rate and history,
  /// and 20 times for time.
  bool structured() const;
};

struct ResidualBin {
  double at = 0;  ///< mean of the variable
  double mean_dph = 0;
  double sigma_dph = 0;  ///< standard error of the mean
  std::size_t rows = 0;
};

/// The residual as a function of one variable.
struct Dependence {
  std::vector<ResidualBin> bins;  ///< of equal width, those with at least 5 rows
  ClassTest test;
};

/// `bins`: number over the variable's range. Noise too slow to show in the soaks, such as a
/// variation over a day, counts as dependence on time.
Dependence dependence_on(const std::vector<double>& variable, const ResidualRows& rows,
                         std::size_t bins);

struct LoopBin {
  double at_degc = 0;
  double heating_dph = 0;  ///< mean of the residual on the heating branch
  double cooling_dph = 0;
  double sigma_dph = 0;  ///< of their difference
  double width_dph() const { return heating_dph - cooling_dph; }
};

/// Dependence of the residual on history: heating against cooling branch at equal temperature.
struct Loop {
  std::vector<LoopBin> bins;  ///< those with at least 5 rows on each branch
  ClassTest test;             ///< of the branches' difference within the bins

  /// The bin with the largest |heating - cooling|; nullptr without bins.
  const LoopBin* widest() const;
};

/// Whether the mean of all rows differs from 0.
ClassTest test_of_mean(const ResidualRows& rows);
/// Standard error of that mean, deg/h.
double sigma_of_mean(const ResidualRows& rows);

/// For the branches() of the temperature.
Loop loop_over(const std::vector<double>& temperature_degc, const ResidualRows& rows,
               std::size_t bins);

}  // namespace fogcomp::compare
