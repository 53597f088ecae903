#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "recording/segments.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Values in order of time, and which of them are neighbours.
struct ValuesInTime {
  std::vector<double> values;
  std::vector<double> weights;  ///< 1 for a full row, less for a part of one; empty: 1
  std::vector<recording::RowRange> stretches;  ///< without a gap
  std::vector<std::vector<double>> inputs;     ///< what else was measured, a value per row each
};

/// Whether each value is an outlier: one to three rows that stand off the rows before and the rows
/// after to the same side,
///   * by more than 4 sigma of white noise, or by what noise alone exceeds in every second
///     recording of this length where that is more (Chauvenet's criterion); sigma from the second
///     differences, of the whole recording or of the 50 rows around, whichever is larger;
///   * and by more than 3 times the scatter of those neighbours about their median, at the end of a
///     stretch 3 times their range.
/// The second keeps curves, corners, decays and oscillations of any size, the first keeps noise
/// that is larger in a part of the recording; steps, ramps and slow excursions stand off one side
/// at most. Rows are held against the nearest ones with the same inputs: a short turn of a rate
/// table is no outlier. What is so short without an input that moves cannot be told from one.
///
/// The values are those measured, without any model: no effect that a model has or lacks decides
/// which rows count, and all models are judged by the same rows.
std::vector<bool> find_outliers(const ValuesInTime& rows);

/// Of the drift of `rows`, by the inputs of the same time: 1 for each that counts, 0 for each
/// outlier.
Eigen::VectorXd counted_rows(const series::Rows& rows);
/// The time behind each row that has a weight, 0 for the others: what an rms is taken over.
Eigen::VectorXd counted_weights(const series::Rows& rows, const Eigen::VectorXd& row_weights);

/// `values` with a straight line between the nearest ones that count in place of each that does
/// not; the nearest one at either end of a stretch.
void bridge_outliers(const std::vector<bool>& outlier,
                     const std::vector<recording::RowRange>& stretches,
                     std::vector<double>& values);
/// The same of a value per row; `counted`: 0 for each that does not count.
Eigen::VectorXd bridged(const series::Rows& rows, const Eigen::VectorXd& values,
                        const Eigen::VectorXd& counted);

/// "3 rows of 10 s left out: each stands out of its neighbours by more than 4 sigma of the noise";
/// "" for none.
std::string outlier_words(std::size_t rows, double row_s);

}  // namespace fogcomp::noise
