#pragma once

#include <cstddef>
#include <vector>

namespace fogcomp::denoise {

/// Outputs per iteration of a kernel: array lengths are multiples of it.
constexpr std::size_t kKernelStep = 8;

/// The two filters of a transform, split into even and odd taps.
struct FilterPair {
  explicit FilterPair(const std::vector<double>& lowpass);
  struct Taps {
    double low_even, low_odd, high_even, high_odd;
  };
  std::vector<Taps> taps;  ///< one per two taps of a filter
  std::size_t length() const { return 2 * taps.size(); }
};

// Inner loops of a transform on separate even and odd samples. `count` is a multiple of
// kKernelStep; results must not overlap inputs. With p = taps / 2 - 1:

/// low[k] = sum over i of low_even[i] odd[k + p - i] + low_odd[i] even[k + p - i]; high likewise.
/// Reads even and odd up to count + p.
void analyse(const FilterPair& filters, const double* even, const double* odd, std::size_t count,
             double* low, double* high);
/// even[k] = sum over i of low_odd[i] low[k + i] + high_odd[i] high[k + i]; odd[k] with the even
/// taps. Reads low and high up to count + p.
void synthesise(const FilterPair& filters, const double* low, const double* high, std::size_t count,
                double* even, double* odd);

}  // namespace fogcomp::denoise
