#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "batch/gyro_result.hpp"

namespace fogcomp::batch {

/// A figure over the gyros of a lot.
struct LotFigure {
  std::string name;
  std::size_t gyros = 0;  ///< that have it
  double median = 0;
  /// 1.4826 times the median distance from the median: the standard deviation of a normal lot, to
  /// which a few bad gyros do nothing. Of ln(figure) where `ratios`: noise and residuals differ by
  /// factors.
  double spread = 0;
  bool ratios = false;

  /// Distance of a value from the median in spreads.
  double score(double value) const;
  /// The value that lies so many spreads from the median.
  double value_at(double score) const;
};

/// A gyro that is not like the others, and the figure that makes it one.
struct Outlier {
  std::string gyro;
  std::string figure;
  double value = 0;
  double score = 0;  ///< beyond Lot::bound
};

/// What a lot says of its gyros by itself, limits or not: noise, residual and coefficients of the
/// drift, each beside its median over the lot. Shape parameters are not compared: a period or a
/// time constant has no one place about which gyros scatter.
struct Lot {
  std::vector<LotFigure> figures;  ///< that are compared
  /// Largest |score| among all gyros and figures that a lot of normal figures reaches in 1 % of all
  /// lots. The spread of a small lot is known badly, so its bound is high: of 15 figures 44 for 8
  /// gyros, 17 for 12, 7.1 for 30, 5.3 for 100.
  double bound = 0;
  std::vector<Outlier> outliers;  ///< worst first, a gyro once for each of its figures
};

/// Fewer gyros have no median worth comparing with.
constexpr std::size_t kMinLot = 8;

/// `compared`: names of the figures that are asked; a name `EFFECT.COEFFICIENT` is compared by
/// differences, any other by ratios. One that fewer than kMinLot gyros have, or that does not
/// differ between most of them, is left out.
Lot compare_lot(const std::vector<GyroResult>& results, const std::vector<std::string>& compared);

/// The outlier's place in the lot: "noise_dprh 0.0024 (lot 0.0012 +- 3 %, 19 spreads above)".
std::string outlier_words(const Lot& lot, const Outlier& outlier);

}  // namespace fogcomp::batch
