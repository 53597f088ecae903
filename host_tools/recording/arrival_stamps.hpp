#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace fogcomp::recording {

/// Evenly sampled rows whose times are those at which they arrived.
struct EvenTimes {
  std::vector<double> time_s;  ///< of each row, when it was sampled
  double rate_hz = 0;
  double rate_sigma_hz = 0;
  std::size_t gaps_before = 0;  ///< spacings that would count as gaps, as the rows arrived
  std::size_t gaps_after = 0;   ///< where samples are lost
};

/// Recognises times of arrival: packets, a queue behind a stalled reader, a clock that is read
/// coarsely. Each sample is late by a delay that comes and goes, so that spacings scatter but their
/// sums do not: what a pause takes, the next spacings give back, unlike at lost samples. The least
/// delayed sample of each window is a time that is known; between these the samples are even.
///
/// `time_s`: not falling; rows may have the same time. Nothing if most gaps are gaps, or all but a
/// few (rules::kMinWindows), if
/// spacings scatter like losses or if the delays are longer than the pauses that would explain
/// them. Pauses above rules::kMaxDropoutS are gaps unless the rows after them make up for them.
std::optional<EvenTimes> even_times(const std::vector<double>& time_s);

}  // namespace fogcomp::recording
