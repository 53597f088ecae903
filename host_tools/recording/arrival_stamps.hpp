#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace fogcomp::recording {

/// Evenly sampled rows whose times are those at which they arrived.
struct EvenTimes {
  /// False: too many samples are lost, or delays are too long, for the rest to be known.
  bool is_known = false;
  std::vector<double> time_s;  ///< of each row, when it was sampled
  double rate_hz = 0;
  double rate_sigma_hz = 0;
  std::size_t uneven_before = 0;  ///< spacings that are no period, as the rows arrived
  std::size_t gaps_after = 0;     ///< where samples are lost
};

/// Times of rows that a coarse clock stamps, several alike (a log with minutes only): samples of
/// this rate are counted, and lost where the clock is more than a sample ahead. Nothing if there
/// are more rows than its time allows, samples lost at most of its times, or only one time.
std::optional<std::vector<double>> counted_times(const std::vector<double>& stamp_s,
                                                 double rate_hz);

/// Recognises times of arrival: packets, a queue behind a stalled reader, a clock that is read
/// coarsely. Each sample is late by a delay that comes and goes, so that spacings scatter but their
/// sums do not: what a pause takes, the next spacings give back, unlike at lost samples. The least
/// delayed sample of each window is a time that is known; between these the samples are even, and
/// lost where whole periods are missing.
///
/// `time_s`: not falling; rows may have the same time. Nothing if the rows may be there when they
/// were sampled: next to none comes early, and pauses do not make up for each other, or most are
/// losses all the same.
/// Pauses above rules::kMaxDropoutS are gaps unless the rows after them make up for them. Without
/// `rate_hz` the sample rate is found where enough windows lose nothing (rules::kShareWithoutLoss).
std::optional<EvenTimes> even_times(const std::vector<double>& time_s,
                                    const std::optional<double>& rate_hz = std::nullopt);

}  // namespace fogcomp::recording
