#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "batch/gyro_result.hpp"
#include "support/evidence.hpp"

namespace fogcomp::batch {

/// A value over the gyros of a lot.
struct LotFigure {
  std::string name;
  std::size_t gyros = 0;  ///< that have the value
  double median = 0;
  /// 1.4826 times the median distance from the median: the standard deviation of a normal lot,
  /// robust against a few bad gyros. Of ln(value) if `ratios`, because noise and residuals differ
  /// by factors.
  double spread = 0;
  bool ratios = false;

  /// Distance of `value` from the median, in spreads.
  double score(double value) const;
  /// Value at that distance from the median.
  double value_at(double score) const;
};

/// A gyro that differs from the lot, and the value that shows it.
struct Outlier {
  std::string gyro;
  std::string figure;
  double value = 0;
  double score = 0;  ///< exceeds Lot::bound
};

/// Comparison of a lot's gyros with each other, independent of limits: noise, residual and drift
/// coefficients relative to their medians. Shape parameters are not compared, because a period or a
/// time constant does not scatter about one value.
struct Lot {
  std::vector<LotFigure> figures;  ///< compared values
  /// Largest |score| over all gyros and values that 1 % of normal lots reach. High for a small lot,
  /// whose spread is uncertain: for 15 values 44 with 8 gyros, 17 with 12, 7.1 with 30, 5.3 with
  /// 100.
  double bound = 0;
  std::vector<Outlier> outliers;  ///< worst first; a gyro once per value
};

/// `compared`: names of the values; `EFFECT.COEFFICIENT` is compared by differences, others by
/// ratios. Values that fewer than kMinLot gyros have, or that are equal for most of them, are left
/// out.
Lot compare_lot(const std::vector<GyroResult>& results, const std::vector<std::string>& compared);

/// Position of an outlier in the lot: "noise_dprh 0.0024 (lot 0.0012 +- 3 %, 19 spreads above)".
std::string outlier_words(const Lot& lot, const Outlier& outlier);

}  // namespace fogcomp::batch
