#include "denoise/transform.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace fogcomp::denoise {
namespace {

// Outputs per chunk: with its inputs it fits the first-level cache.
constexpr std::size_t kChunk = 512;
constexpr std::size_t kMaxPhases = 15;  // coif5
constexpr std::size_t kBuffer = kChunk + kMaxPhases + kKernelStep;
using Buffer = std::array<double, kBuffer>;

// Index in [0, size) of the value at `index` of the extended signal.
std::size_t extended(std::ptrdiff_t index, std::size_t size, Extension extension) {
  const auto period =
      static_cast<std::ptrdiff_t>(extension == Extension::periodic ? size : 2 * size);
  const std::ptrdiff_t wrapped = ((index % period) + period) % period;
  const auto inside = static_cast<std::size_t>(wrapped);
  return inside < size ? inside : 2 * size - 1 - inside;
}

std::size_t padded(std::size_t count) {
  return (count + kKernelStep - 1) / kKernelStep * kKernelStep;
}

// Pairs (even, odd) of the extended signal, from number first_pair on.
void separate(fog::Span<const double> values, std::ptrdiff_t first_pair, std::size_t pairs,
              Extension extension, double* even, double* odd) {
  const std::ptrdiff_t begin = 2 * first_pair;
  const auto end = begin + static_cast<std::ptrdiff_t>(2 * pairs);
  if (begin >= 0 && end <= static_cast<std::ptrdiff_t>(values.size)) {
    const double* from = values.data + begin;
    for (std::size_t i = 0; i < pairs; ++i) {
      even[i] = from[2 * i];
      odd[i] = from[2 * i + 1];
    }
    return;
  }
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::ptrdiff_t at = begin + static_cast<std::ptrdiff_t>(2 * i);
    even[i] = values[extended(at, values.size, extension)];
    odd[i] = values[extended(at + 1, values.size, extension)];
  }
}

std::size_t coefficients_of(std::size_t length, const FilterPair& filters) {
  return (length + filters.length() - 1) / 2;
}

// `low` and `high` have at least coefficients_of(values) elements.
void analyse_level(fog::Span<const double> values, const FilterPair& filters, Extension extension,
                   double* low, double* high) {
  const std::size_t phases = filters.taps.size();
  const std::size_t outputs = coefficients_of(values.size, filters);
  Buffer even{};
  Buffer odd{};
  Buffer low_part;
  Buffer high_part;
  for (std::size_t first = 0; first < outputs; first += kChunk) {
    const std::size_t count = std::min(kChunk, outputs - first);
    separate(values, static_cast<std::ptrdiff_t>(first) - static_cast<std::ptrdiff_t>(phases - 1),
             count + phases - 1, extension, even.data(), odd.data());
    if (count == padded(count)) {
      analyse(filters, even.data(), odd.data(), count, low + first, high + first);
      continue;
    }
    analyse(filters, even.data(), odd.data(), padded(count), low_part.data(), high_part.data());
    std::copy_n(low_part.data(), count, low + first);
    std::copy_n(high_part.data(), count, high + first);
  }
}

// Transpose of analyse_level: combines the coefficients at the front of `values` with `high`.
// Backwards, so that every coefficient is read before it is overwritten. A level of odd length
// keeps its length.
void synthesise_level(const double* high, const FilterPair& filters, fog::Span<double> values) {
  const std::size_t phases = filters.taps.size();
  Buffer low_part{};
  Buffer high_part{};
  Buffer even;
  Buffer odd;
  const std::size_t pairs = (values.size + 1) / 2;
  for (std::size_t end = pairs; end > 0;) {
    const std::size_t first = (end - 1) / kChunk * kChunk;
    const std::size_t count = end - first;
    if (count == padded(count)) {
      synthesise(filters, values.data + first, high + first, count, even.data(), odd.data());
    } else {
      std::copy_n(values.data + first, count + phases - 1, low_part.data());
      std::copy_n(high + first, count + phases - 1, high_part.data());
      synthesise(filters, low_part.data(), high_part.data(), padded(count), even.data(),
                 odd.data());
    }
    const std::size_t whole = std::min(count, values.size / 2 - first);
    double* to = values.data + 2 * first;
    for (std::size_t i = 0; i < whole; ++i) {
      to[2 * i] = even[i];
      to[2 * i + 1] = odd[i];
    }
    if (whole < count) to[2 * whole] = even[whole];
    end = first;
  }
}

}  // namespace

int max_levels(std::size_t length, std::size_t taps) {
  int levels = 0;
  for (std::size_t length_needed = 2 * (taps - 1); length_needed <= length; length_needed *= 2)
    ++levels;
  return levels;
}

Decomposition decompose(fog::Span<const double> values, const std::vector<double>& lowpass,
                        int levels, Extension extension) {
  const FilterPair filters(lowpass);
  Decomposition result;
  result.length = values.size;
  fog::Span<const double> input = values;
  std::array<std::vector<double>, 2> approximations;  // used alternately
  for (int level = 0; level < levels; ++level) {
    const std::size_t outputs = coefficients_of(input.size, filters);
    std::vector<double>& low = approximations[static_cast<std::size_t>(level % 2)];
    // Levels get shorter, unless they are shorter than the filter.
    if (level < 2) low = std::vector<double>(std::max(outputs, filters.length()));
    std::vector<double> high(outputs);
    analyse_level(input, filters, extension, low.data(), high.data());
    result.details.push_back(std::move(high));
    input = {low.data(), outputs};
  }
  result.approximation = std::vector<double>(input.size);
  std::copy(input.begin(), input.end(), result.approximation.begin());
  return result;
}

void reconstruct(const Decomposition& decomposition, const std::vector<double>& lowpass,
                 fog::Span<double> values) {
  const FilterPair filters(lowpass);
  // Levels grow in place. With a signal shorter than the filter they are longer than it.
  const std::vector<double>& coarsest = decomposition.approximation;
  std::vector<double> longer(coarsest.size() > values.size ? coarsest.size() : 0);
  double* const work = longer.size() > 0 ? longer.data() : values.data;
  std::copy(coarsest.begin(), coarsest.end(), work);
  for (std::size_t level = decomposition.details.size(); level-- > 0;) {
    const std::size_t size = level > 0 ? decomposition.details[level - 1].size() : values.size;
    synthesise_level(decomposition.details[level].data(), filters, {work, size});
  }
  if (longer.size() > 0) std::copy_n(work, values.size, values.data);
}

}  // namespace fogcomp::denoise
