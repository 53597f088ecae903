#include "support/gram.hpp"

#include <algorithm>

namespace fogcomp {
namespace {

using Eigen::Index;

// A strip is kStrip columns side by side, row by row; a tile is the inner products of kTile columns
// of one strip with a strip. Its sums fill the registers of AVX2.
constexpr Index kStrip = 8;
constexpr Index kTile = 4;
constexpr Index kPanel = 256;  // rows at a time: some strips stay in the cache

// Each sum is formed row by row, and AVX2 has no fused multiplication: both clones give the same
// bits.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define FOGCOMP_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define FOGCOMP_WIDE
#endif

FOGCOMP_WIDE void set_tile(const double* tile, const double* strip, Index rows, double* sums) {
  double local[kTile][kStrip] = {};
  for (Index row = 0; row < rows; ++row, tile += kStrip, strip += kStrip) {
    for (Index i = 0; i < kTile; ++i) {
      for (Index j = 0; j < kStrip; ++j) local[i][j] += tile[i] * strip[j];
    }
  }
  for (Index i = 0; i < kTile; ++i) {
    for (Index j = 0; j < kStrip; ++j) sums[i * kStrip + j] = local[i][j];
  }
}

// Rows of a panel as strips; the last one is filled up with zeros.
void pack(const std::vector<const double*>& columns, Index first, Index rows,
          std::vector<double>& strips) {
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double* to = strips.data() + c / kStrip * (kStrip * kPanel) + c % kStrip;
    for (Index row = 0; row < rows; ++row) to[row * kStrip] = columns[c][first + row];
  }
}

}  // namespace

Eigen::MatrixXd gram(const std::vector<Eigen::MatrixXd>& parts) {
  std::vector<const double*> columns;
  for (const Eigen::MatrixXd& part : parts) {
    for (Index i = 0; i < part.cols(); ++i) columns.push_back(part.col(i).data());
  }
  const Index rows = parts.empty() ? 0 : parts.front().rows();
  const auto size = static_cast<Index>(columns.size());
  const Index strips = (size + kStrip - 1) / kStrip;
  std::vector<double> packed(static_cast<std::size_t>(strips * kStrip * kPanel));
  // kStrip rows for each strip, so that a tile's sums are neighbours.
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(strips * kStrip, strips * kStrip);
  for (Index first = 0; first < rows; first += kPanel) {
    const Index count = std::min(kPanel, rows - first);
    pack(columns, first, count, packed);
    for (Index strip = 0; strip < strips; ++strip) {
      for (Index other = 0; other < (strip + 1) * kStrip; other += kTile) {
        double sums[kTile * kStrip];
        const double* const tile =
            packed.data() + other / kStrip * (kStrip * kPanel) + other % kStrip;
        set_tile(tile, packed.data() + strip * kStrip * kPanel, count, sums);
        products.block<kStrip, kTile>(strip * kStrip, other) +=
            Eigen::Map<const Eigen::Matrix<double, kStrip, kTile>>(sums);
      }
    }
  }
  return products.topLeftCorner(size, size).selfadjointView<Eigen::Lower>();
}

}  // namespace fogcomp
