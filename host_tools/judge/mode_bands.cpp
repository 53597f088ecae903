#include "judge/mode_bands.hpp"

#include <cmath>
#include <map>

#include "support/cosine_transform.hpp"
#include "support/decompositions.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr double kBandsPerOctave = 12;

struct Band {
  double log_angle = 0;
  double count = 0;
  Eigen::MatrixXd lower;  // sums of products, lower triangle
};

int band_of(double angle) {
  return static_cast<int>(std::floor(kBandsPerOctave * std::log2(angle)));
}

void add_stretch(const Eigen::MatrixXd& modes, std::map<int, Band>& bands) {
  const auto size = static_cast<double>(modes.rows());
  const auto angle_of = [&](Eigen::Index k) {
    return 2 * std::sin(kPi * std::max(static_cast<double>(k), 0.5) / (2 * size));
  };
  for (Eigen::Index first = 0; first < modes.rows();) {
    const int number = band_of(angle_of(first));
    Band& band = bands[number];
    Eigen::Index end = first;
    for (; end < modes.rows() && band_of(angle_of(end)) == number; ++end) {
      band.log_angle += std::log(angle_of(end));
      ++band.count;
    }
    if (band.lower.size() == 0) band.lower.setZero(modes.cols(), modes.cols());
    add_to_gram(modes.middleRows(first, end - first), band.lower);
    first = end;
  }
}

}  // namespace

ModeBands mode_bands(const Eigen::MatrixXd& columns,
                     const std::vector<recording::RowRange>& stretches) {
  std::map<int, Band> found;
  for (const recording::RowRange& stretch : stretches) {
    add_stretch(cosine_transform(columns.middleRows(static_cast<Eigen::Index>(stretch.first),
                                                    static_cast<Eigen::Index>(stretch.size()))),
                found);
  }
  ModeBands bands;
  bands.columns = columns.cols();
  const auto size = static_cast<Eigen::Index>(found.size());
  bands.angle.resize(size);
  bands.count.resize(size);
  bands.products.resize(bands.columns * (bands.columns + 1) / 2, size);
  Eigen::Index at = 0;
  for (const auto& [number, band] : found) {
    bands.angle[at] = std::exp(band.log_angle / band.count);
    bands.count[at] = band.count;
    Eigen::Index place = 0;
    for (Eigen::Index j = 0; j < bands.columns; ++j) {
      for (Eigen::Index i = 0; i <= j; ++i) bands.products(place++, at) = band.lower(j, i);
    }
    ++at;
  }
  return bands;
}

Eigen::MatrixXd weighted_products(const ModeBands& bands, const Eigen::VectorXd& weighted) {
  Eigen::MatrixXd all(bands.columns, bands.columns);
  Eigen::Index place = 0;
  for (Eigen::Index j = 0; j < bands.columns; ++j) {
    for (Eigen::Index i = 0; i <= j; ++i) {
      all(i, j) = weighted[place++];
      all(j, i) = all(i, j);
    }
  }
  return all;
}

}  // namespace fogcomp::judge
