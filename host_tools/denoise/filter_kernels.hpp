#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::denoise {

/// Outputs per iteration of the kernel: array lengths are multiples of it.
constexpr std::size_t kKernelStep = 8;

/// The two filters of a transform, split into even and odd taps, for either direction.
struct FilterPair {
  explicit FilterPair(const std::vector<double>& lowpass);
  /// What two outputs take of two inputs.
  struct Taps {
    double first_of_x, first_of_y, second_of_x, second_of_y;
  };
  std::vector<Taps> analysis;   ///< low and high of odd and even samples
  std::vector<Taps> synthesis;  ///< even and odd samples of low and high
  std::size_t phases() const { return analysis.size(); }
  std::size_t length() const { return 2 * phases(); }
};

/// Two outputs of two inputs: first[k] = sum over i of first_of_x[i] x[k + i] + first_of_y[i] y[k +
/// i], second[k] likewise. `backwards`: of inputs from the last tap's on, x[k + taps - 1 - i].
/// `count` is a multiple of kKernelStep; outputs must not overlap inputs, which are read up to
/// count
/// + taps - 1.
void filter(const std::vector<FilterPair::Taps>& taps, bool backwards, const double* x,
            const double* y, std::size_t count, double* first, double* second);

}  // namespace fogcomp::denoise
