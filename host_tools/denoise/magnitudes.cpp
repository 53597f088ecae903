#include "denoise/magnitudes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace fogcomp {
namespace {

constexpr int kMantissaBits = 6;  // 64 buckets to an octave
constexpr int kDroppedBits = 52 - kMantissaBits;
constexpr std::size_t kBuckets = std::size_t{32} << kMantissaBits;

// Positive doubles are in the order of their bits.
std::uint64_t bits_of(double magnitude) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &magnitude, sizeof bits);
  return bits;
}

double largest_magnitude(fog::Span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

Magnitudes::Magnitudes(fog::Span<const double> values) : values_(values), buckets_(kBuckets) {
  const std::uint64_t last_key = bits_of(largest_magnitude(values)) >> kDroppedBits;
  first_key_ = last_key < kBuckets ? 0 : last_key - (kBuckets - 1);
  for (const double value : values) {
    Bucket& bucket = buckets_[bucket_of(std::abs(value))];
    ++bucket.count;
    bucket.squares += value * value;
  }
}

std::size_t Magnitudes::bucket_of(double magnitude) const {
  const std::uint64_t key = bits_of(magnitude) >> kDroppedBits;
  return key < first_key_ ? 0 : key - first_key_;
}

double Magnitudes::lower_edge(std::size_t bucket) const {
  if (bucket == 0) return 0;
  const std::uint64_t bits = (first_key_ + bucket) << kDroppedBits;
  double edge = 0;
  std::memcpy(&edge, &bits, sizeof edge);
  return edge;
}

std::vector<double> Magnitudes::sorted_members(const std::vector<char>& wanted) const {
  std::vector<double> members;
  for (const double value : values_) {
    const double magnitude = std::abs(value);
    if (wanted[bucket_of(magnitude)] != 0) members.push_back(magnitude);
  }
  std::sort(members.begin(), members.end());
  return members;
}

double Magnitudes::median() const {
  const std::size_t low_rank = (values_.size - 1) / 2;
  const std::size_t high_rank = values_.size / 2;
  std::vector<char> wanted(buckets_.size(), 0);
  std::size_t before = 0;   // values in lower buckets
  std::size_t skipped = 0;  // of these, not among the members
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    const std::size_t end = before + buckets_[b].count;
    const bool holds_low = low_rank >= before && low_rank < end;
    const bool holds_high = high_rank >= before && high_rank < end;
    wanted[b] = holds_low || holds_high ? 1 : 0;
    if (end <= low_rank) skipped = end;
    before = end;
  }
  const std::vector<double> members = sorted_members(wanted);
  return (members[low_rank - skipped] + members[high_rank - skipped]) / 2;
}

double Magnitudes::sum_of_squares() const {
  double sum = 0;
  for (const Bucket& bucket : buckets_) sum += bucket.squares;
  return sum;
}

double Magnitudes::least_risk(double sigma) const {
  const auto n = static_cast<double>(values_.size);
  const double variance = sigma * sigma;
  // The risk at the end of each bucket is at most `most`, at its edge; within a bucket it is at
  // least `least`, as if all its values stood at its lower edge. Only where that undercuts every
  // `most` can the minimum be.
  double most = std::numeric_limits<double>::infinity();
  std::vector<double> least(buckets_.size(), std::numeric_limits<double>::infinity());
  double before = 0;
  double squares = 0;
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    if (buckets_[b].count == 0) continue;
    const double end = before + static_cast<double>(buckets_[b].count);
    const double lower = lower_edge(b);
    const double upper = lower_edge(b + 1);
    least[b] = n - 2 * end + (squares + (n - before) * lower * lower) / variance;
    squares += buckets_[b].squares;
    most = std::min(most, n - 2 * end + (squares + (n - end) * upper * upper) / variance);
    before = end;
  }
  std::vector<char> wanted(buckets_.size(), 0);
  // The bounds are sums in another order than the risks: a rounding error of room between them.
  const double limit = most + 1e-9 * (std::abs(most) + n);
  for (std::size_t b = 0; b < buckets_.size(); ++b) wanted[b] = least[b] <= limit ? 1 : 0;

  const std::vector<double> members = sorted_members(wanted);
  std::size_t next = 0;
  double k = 0;
  squares = 0;
  double best_risk = std::numeric_limits<double>::infinity();
  double best = 0;
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    if (wanted[b] == 0) {
      k += static_cast<double>(buckets_[b].count);
      squares += buckets_[b].squares;
      continue;
    }
    for (std::size_t i = 0; i < buckets_[b].count; ++i) {
      const double square = members[next] * members[next];
      k += 1;
      squares += square;
      const double risk = n - 2 * k + (squares + (n - k) * square) / variance;
      if (risk < best_risk) {
        best_risk = risk;
        best = members[next];
      }
      ++next;
    }
  }
  return best;
}

}  // namespace fogcomp
