#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/signal/span.hpp"

namespace fogcomp {

/// Order statistics of the magnitudes of many values without sorting them all: they are counted
/// into buckets by the leading bits of their binary form (64 to an octave, the 32 octaves below the
/// largest; smaller ones share the first bucket), and only the buckets in question are sorted.
/// Exact. Linear in time unless the values crowd into few buckets.
class Magnitudes {
 public:
  /// `values` must outlive this; at least one, all finite.
  explicit Magnitudes(fog::Span<const double> values);

  /// The middle one, or the mean of the two in the middle.
  double median() const;

  double sum_of_squares() const;

  /// The magnitude t that minimises Stein's unbiased estimate of the risk of soft thresholding at t
  /// values with noise of standard deviation `sigma` > 0 (MATLAB's thselect "rigrsure", times
  /// sigma). With the magnitudes in order m1 <= m2 ... <= mn, the smallest of
  ///   n - 2 k + (m1^2 + ... + mk^2 + (n - k) mk^2) / sigma^2,   k = 1 ... n.
  double least_risk(double sigma) const;

 private:
  struct Bucket {
    std::size_t count = 0;
    double squares = 0;
  };
  std::size_t bucket_of(double magnitude) const;
  double lower_edge(std::size_t bucket) const;
  /// In ascending order, all magnitudes of the buckets marked.
  std::vector<double> sorted_members(const std::vector<char>& wanted) const;

  fog::Span<const double> values_;
  std::uint64_t first_key_ = 0;  ///< leading bits of the first bucket
  std::vector<Bucket> buckets_;
};

}  // namespace fogcomp
