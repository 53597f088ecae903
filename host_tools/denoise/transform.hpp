#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/signal/span.hpp"
#include "denoise/filter_kernels.hpp"

namespace fogcomp::denoise {

/// What stands beyond the ends of a signal x0 x1 ... xn. Names and meaning as PyWavelets.
enum class Extension : std::uint8_t {
  symmetric,  ///< half-point mirror: ... x1 x0 | x0 x1 ... xn | xn ...
  periodic,   ///< ... xn | x0 x1 ... xn | x0 ...
};

/// A signal taken apart by an orthogonal discrete wavelet transform (PyWavelets' wavedec).
struct Decomposition {
  std::vector<double> approximation;         ///< of the coarsest level
  std::vector<std::vector<double>> details;  ///< [0] is level 1, the finest
  std::size_t length = 0;                    ///< of the signal
};

/// Levels at which the filter is no longer than what it filters: PyWavelets' dwt_max_level.
/// 0 where the signal has fewer than 2 (taps - 1) values.
int max_levels(std::size_t length, std::size_t taps);

/// Takes `values` (at least one) apart. Any number of levels works; max_levels() says beyond which
/// a level is made of extension more than of signal. A level of n values gives
/// (n + taps - 1) / 2 coefficients, rounded down.
Decomposition decompose(fog::Span<const double> values, const std::vector<double>& lowpass,
                        int levels, Extension extension = Extension::symmetric);

/// The signal again, exact to rounding for either extension; `values` has its length.
void reconstruct(const Decomposition& decomposition, const std::vector<double>& lowpass,
                 fog::Span<double> values);

}  // namespace fogcomp::denoise
