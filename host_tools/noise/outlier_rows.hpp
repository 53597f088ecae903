#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recording/segments.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Values in order of time, with their stretches.
struct ValuesInTime {
  std::vector<double> values;
  std::vector<double> weights;  ///< 1 for a full row, less for a part of one; empty: 1
  std::vector<recording::RowRange> stretches;  ///< without a gap
  std::vector<std::vector<double>> inputs;     ///< other inputs, one value per row each
};

/// Finds outliers: one to three rows that deviate from the rows before and after, in the same
/// direction,
///   * by more than 4 sigma of white noise, or by what noise alone exceeds in every second
///     recording of this length, whichever is more (Chauvenet's criterion); sigma from second
///     differences of the whole recording or of the 50 rows around, whichever is larger;
///   * and by more than 3 times the scatter of those neighbours about their median; at the end of a
///     stretch, 3 times their range.
/// The second condition keeps curves, corners, decays and oscillations of any size; the local sigma
/// keeps rows of a noisier part; steps, ramps and slow excursions deviate from one side at most.
/// Rows are compared with the nearest ones with equal inputs: a short rotation of a rate table is
/// no outlier. A short event whose cause is not an input cannot be distinguished from one.
/// table is no outlier. What is so short without an input that moves cannot be told from one.
///
/// Uses the measured values without a model: no effect decides which rows count, and all models are
/// judged by the same rows.
std::vector<bool> find_outliers(const ValuesInTime& rows);

/// Outliers of the drift of `rows`, given their inputs: 0 for each outlier, else 1.
Eigen::VectorXd counted_rows(const series::Rows& rows);
/// Duration of each row with a weight, 0 for the others: the weights of an rms.
Eigen::VectorXd counted_weights(const series::Rows& rows, const Eigen::VectorXd& row_weights);

/// Replaces each `values` that does not count by interpolation between the nearest ones that do; at
/// the ends of a stretch by the nearest one.
void bridge_outliers(const std::vector<bool>& outlier,
                     const std::vector<recording::RowRange>& stretches,
                     std::vector<double>& values);
/// The same for one value per row; `counted`: 0 for each that does not count.
Eigen::VectorXd bridged(const series::Rows& rows, const Eigen::VectorXd& values,
                        const Eigen::VectorXd& counted);

/// "3 rows of 10 s left out: each stands out of its neighbours by more than 4 sigma of the noise";
/// "" for none.
std::string outlier_words(std::size_t rows, double row_s);

}  // namespace fogcomp::noise
