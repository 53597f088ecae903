#include "noise/allan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "noise/decision_rules.hpp"

namespace fogcomp::noise {
namespace {

// Independent partial sums, so that additions need not wait for each other.
constexpr std::size_t kLanes = 8;

double sum_of_squared_differences(const double* c, std::size_t m, std::size_t count) {
  std::array<double, kLanes> sums{};
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t at = i + lane;
      const double difference = c[at + 2 * m] - 2 * c[at + m] + c[at];
      sums[lane] += difference * difference;
    }
  }
  double sum = 0;
  for (; i < count; ++i) {
    const double difference = c[i + 2 * m] - 2 * c[i + m] + c[i];
    sum += difference * difference;
  }
  for (const double lane : sums) sum += lane;
  return sum;
}

// The mean, which does not affect the deviation, is subtracted to keep the sums small and exact.
void cumulate(const std::vector<double>& values, recording::RowRange range,
              std::vector<double>& c) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(range.first);
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(range.end);
  double total = 0;
  for (auto value = first; value != end; ++value) total += *value;
  const double mean = total / static_cast<double>(range.size());
  c.clear();
  c.push_back(0);
  double sum = 0;
  for (auto value = first; value != end; ++value) c.push_back(sum += *value - mean);
}

struct Octave {
  double sum = 0;    // of squared second differences
  double count = 0;  // of them
  double pairs = 0;
  std::size_t ranges = 0;
};

// All octaves in one pass: a chunk of C stays in the cache for the short ones, and the values that
// a long one reads at 2m are read again at m.
void accumulate(const std::vector<double>& c, std::vector<Octave>& octaves) {
  constexpr std::size_t kChunk = 2048;
  const std::size_t n = c.size() - 1;
  for (std::size_t first = 0; first < n; first += kChunk) {
    for (std::size_t k = 0; k < octaves.size(); ++k) {
      const std::size_t m = std::size_t{1} << k;
      if (first + 2 * m > n) break;
      const std::size_t count = std::min(kChunk, n - 2 * m - first + 1);
      octaves[k].sum += sum_of_squared_differences(c.data() + first, m, count);
      octaves[k].count += static_cast<double>(count);
    }
  }
  for (std::size_t k = 0; k < octaves.size() && (std::size_t{2} << k) <= n; ++k) {
    octaves[k].pairs += static_cast<double>(n) / static_cast<double>(std::size_t{1} << k) - 1;
    ++octaves[k].ranges;
  }
}

}  // namespace

std::vector<AllanPoint> allan_deviation(const std::vector<double>& values,
                                        const std::vector<recording::RowRange>& ranges,
                                        double period_s) {
  std::size_t longest = 0;
  for (const recording::RowRange& range : ranges) longest = std::max(longest, range.size());
  std::vector<Octave> octaves;
  while ((std::size_t{2} << octaves.size()) <= longest) octaves.emplace_back();

  std::vector<double> c;
  c.reserve(longest + 1);
  for (const recording::RowRange& range : ranges) {
    if (range.size() < 2) continue;
    cumulate(values, range, c);
    accumulate(c, octaves);
  }

  std::vector<AllanPoint> points;
  for (std::size_t k = 0; k < octaves.size() && octaves[k].pairs >= rules::kMinAllanPairs; ++k) {
    AllanPoint point;
    point.samples = std::size_t{1} << k;
    const auto m = static_cast<double>(point.samples);
    point.tau_s = m * period_s;
    point.sigma = std::sqrt(octaves[k].sum / octaves[k].count / 2) / m;
    point.pairs = octaves[k].pairs;
    point.ranges = octaves[k].ranges;
    point.one_sigma = point.sigma / std::sqrt(2 * point.pairs);
    points.push_back(point);
  }
  return points;
}

std::vector<recording::RowRange> soak_ranges(const recording::Recording& recording,
                                             const std::vector<recording::Segment>& segments) {
  std::vector<recording::RowRange> ranges;
  for (const recording::Segment& segment : segments) {
    if (segment.kind != recording::SegmentKind::soak) continue;
    const auto parts = recording::stretches_of(recording, segment.rows);
    ranges.insert(ranges.end(), parts.begin(), parts.end());
  }
  return ranges;
}

}  // namespace fogcomp::noise
