#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/signal/span.hpp"
#include "denoise/filter_kernels.hpp"

namespace fogcomp::denoise {

/// Continuation of a signal x0 x1 ... xn beyond its ends. Names and meaning as in PyWavelets.
enum class Extension : std::uint8_t {
  symmetric,  ///< half-point mirror: ... x1 x0 | x0 x1 ... xn | xn ...
  periodic,   ///< ... xn | x0 x1 ... xn | x0 ...
};

/// Orthogonal discrete wavelet transform of a signal (PyWavelets' wavedec).
struct Decomposition {
  fog::Span<double> approximation;         ///< of the coarsest level
  std::vector<fog::Span<double>> details;  ///< [0] is level 1, the finest
  std::unique_ptr<double[]> coefficients;  ///< all of them: what the others point into
};

/// Largest number of levels at which the filter is no longer than its input: PyWavelets'
/// dwt_max_level. 0 for fewer than 2 (taps - 1) values.
int max_levels(std::size_t length, std::size_t taps);

/// Transforms `values` (at least one), which are work space afterwards. Any number of levels works;
/// above max_levels() a level is more extension than signal. A level of n values has (n + taps - 1)
/// / 2 coefficients, rounded down.
Decomposition decompose(fog::Span<double> values, const std::vector<double>& lowpass, int levels,
                        Extension extension = Extension::symmetric);

/// Inverse transform, exact to rounding for either extension; `values` has the original length.
void reconstruct(const Decomposition& decomposition, const std::vector<double>& lowpass,
                 fog::Span<double> values);

}  // namespace fogcomp::denoise
