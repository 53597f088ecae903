#include "diagnosis/fast_structure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/fourier.hpp"
#include "support/statistics.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr std::size_t kFirstLine = 3;  // periods in a run
constexpr std::size_t kSlowLine = 8;   // below, a line must exceed the slow noise around it
constexpr std::size_t kFirstBand = 20;
constexpr std::size_t kNeighbours = 16;  // on either side; they define the usual level
constexpr std::size_t kMaxOctaves = 24;
constexpr std::size_t kMinLines = 8;  // in an octave
constexpr double kMinExcess = 0.2;    // of an octave; less is an inexact noise model
// A level estimated from 32 neighbours is uncertain, which reduces the significance.
constexpr double kLevelUncertainty = 0.75;

struct Octave {
  double power = 0;
  double count = 0;
  double period_s = 0;
};

// Mean power of noise, from the median: half of the lines have less than ln 2 times the mean.
double level_of(const std::vector<double>& powers, std::size_t first, std::size_t end) {
  return median({powers.begin() + static_cast<std::ptrdiff_t>(first),
                 powers.begin() + static_cast<std::ptrdiff_t>(end)}) /
         std::log(2.0);
}

// Mean power two and three lines away on either side. Where slow noise falls with frequency, the
// slower lines make it rather too high than too low.
double level_about(const std::vector<double>& powers, std::size_t line) {
  double sum = 0;
  for (const std::size_t away : {2U, 3U}) {
    sum += powers[line - std::min<std::size_t>(away, line - 1)] + powers[line + away];
  }
  return sum / 4;
}

struct Line {
  double period_s = 0;
  double power = 0;  // relative to its neighbours
};

// The strongest line relative to its neighbours. So an error in the colour of the noise model does
// not matter, nor a line that the soaks contain too and the noise model took for noise.
Line strongest_line(const std::vector<double>& powers, double length_s) {
  Line strongest;
  for (std::size_t k = kFirstLine; k < powers.size(); ++k) {
    const std::size_t first = std::max(kFirstLine, k < kNeighbours ? 0 : k - kNeighbours);
    const std::size_t end = std::min(powers.size(), first + 2 * kNeighbours + 1);
    if (end - first < kNeighbours) break;
    double level = level_of(powers, first, end);
    if (k < kSlowLine) level = std::max(level, level_about(powers, k));
    const double power = level > 0 ? powers[k] / level : 0;
    if (power > strongest.power) strongest = {length_s / static_cast<double>(k), power};
  }
  return strongest;
}

// `fast` with the octave that has the largest excess over white noise of that level.
FastStructure with_band(FastStructure fast, const std::vector<Octave>& octaves, double level,
                        double lines) {
  for (const Octave& octave : octaves) {
    if (octave.count < kMinLines) continue;
    // Twice an exponential variable of mean 1 is chi^2 with two degrees of freedom.
    const double mean = octave.power / octave.count / level;
    const double score = standard_score(2 * octave.count * mean, 2 * octave.count);
    const double log_p = score < 1 ? 0 : tail_log_p(score) + std::log(12.0);
    if (log_p >= fast.band_log_p || mean - 1 < kMinExcess) continue;
    fast.band_log_p = log_p;
    fast.band_excess = mean - 1;
    fast.band_period_s = octave.period_s / octave.count;
    fast.band_share = (mean - 1) * octave.count / lines;
  }
  return fast;
}

}  // namespace

FastStructure find_fast_structure(const series::Rows& rows,
                                  const Eigen::VectorXd& whitened_residual) {
  std::vector<Octave> octaves(kMaxOctaves);
  std::vector<double> all;
  FastStructure fast;
  for (const recording::RowRange& run : rows.runs()) {
    const std::size_t size = run.size();
    const double length_s = static_cast<double>(size) * rows.row_s;
    const auto begin = whitened_residual.begin() + static_cast<std::ptrdiff_t>(run.first);
    const std::vector<double> powers =
        periodogram({begin, begin + static_cast<std::ptrdiff_t>(size)});
    const Line line = strongest_line(powers, length_s);
    if (line.power > fast.line_power) {
      fast.line_power = line.power;
      fast.line_period_s = line.period_s;
    }
    for (std::size_t k = kFirstBand; k < powers.size(); ++k) {
      const double octave = std::log2(static_cast<double>(size) / (2 * static_cast<double>(k)));
      Octave& place = octaves[std::min(kMaxOctaves - 1, static_cast<std::size_t>(octave))];
      place.power += powers[k];
      place.count += 1;
      place.period_s += length_s / static_cast<double>(k);
      all.push_back(powers[k]);
    }
  }
  if (all.empty()) return fast;
  // The level of white noise may differ a little from that of the quiet parts.
  const double level = level_of(all, 0, all.size());
  if (level == 0) return fast;
  const auto lines = static_cast<double>(all.size());
  fast.line_log_p = std::min(0.0, std::log(lines) - kLevelUncertainty * fast.line_power);
  fast.line_share = fast.line_power / lines;
  return with_band(fast, octaves, level, lines);
}

}  // namespace fogcomp::diagnosis
