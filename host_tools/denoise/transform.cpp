#include "denoise/transform.hpp"

#include <algorithm>
#include <array>
#include <numeric>

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

std::size_t coefficients_of(std::size_t length, const FilterPair& filters) {
  return (length + filters.length() - 1) / 2;
}

// Decomposes in place: the approximation of every level stands at the front of `work`. A chunk of a
// level is followed by what the next levels can make of it, while it is in the cache. A chunk is
// copied before its approximations overwrite what the level has read.
class Analysis {
 public:
  Analysis(double* work, std::size_t length, const FilterPair& filters, Extension extension,
           const std::vector<fog::Span<double>>& details)
      : work_(work), filters_(filters), extension_(extension), details_(details) {
    for (const fog::Span<double> detail : details) {
      levels_.push_back({length, detail.size, 0, {}});
      length = levels_.back().outputs;
    }
  }

  void run(std::size_t number = 0) {
    if (number == levels_.size()) return;
    Level& level = levels_[number];
    const std::size_t there = number == 0 ? level.inputs : levels_[number - 1].done;
    while (level.done < level.outputs) {
      const std::size_t count = std::min(kChunk, level.outputs - level.done);
      // The end of a level is mirrored or, in a periodic one, comes before the beginning.
      const bool inside = extension_ == Extension::symmetric && 2 * (level.done + count) <= there;
      if (!inside && there < level.inputs) return;
      analyse_chunk(level, count, details_[number].data + level.done);
      level.done += count;
      run(number + 1);
    }
  }

 private:
  struct Level {
    std::size_t inputs;
    std::size_t outputs;
    std::size_t done;                              // outputs
    std::array<double, 2 * kMaxPhases> beginning;  // the first inputs, which are overwritten early
  };

  void analyse_chunk(Level& level, std::size_t count, double* high) {
    if (level.done == 0) {
      std::copy_n(work_, std::min(level.inputs, level.beginning.size()), level.beginning.begin());
    }
    separate(level, count + filters_.phases() - 1);
    double* const low = work_ + level.done;
    if (count == padded(count)) {
      filter(filters_.analysis, true, odd_.data(), even_.data(), count, low, high);
      return;
    }
    filter(filters_.analysis, true, odd_.data(), even_.data(), padded(count), low_.data(),
           high_.data());
    std::copy_n(low_.data(), count, low);
    std::copy_n(high_.data(), count, high);
  }

  // Pairs (even, odd) of the level's extended input, from those that its next output needs on.
  void separate(const Level& level, std::size_t pairs) {
    const std::ptrdiff_t begin = 2 * (static_cast<std::ptrdiff_t>(level.done) -
                                      static_cast<std::ptrdiff_t>(filters_.phases() - 1));
    const auto end = begin + static_cast<std::ptrdiff_t>(2 * pairs);
    if (begin >= 0 && end <= static_cast<std::ptrdiff_t>(level.inputs)) {
      const double* from = work_ + begin;
      for (std::size_t i = 0; i < pairs; ++i) {
        even_[i] = from[2 * i];
        odd_[i] = from[2 * i + 1];
      }
      return;
    }
    const auto value = [&](std::ptrdiff_t index) {
      const std::size_t at = extended(index, level.inputs, extension_);
      return at < level.beginning.size() ? level.beginning[at] : work_[at];
    };
    for (std::size_t i = 0; i < pairs; ++i) {
      const std::ptrdiff_t at = begin + static_cast<std::ptrdiff_t>(2 * i);
      even_[i] = value(at);
      odd_[i] = value(at + 1);
    }
  }

  double* work_;
  const FilterPair& filters_;
  Extension extension_;
  const std::vector<fog::Span<double>>& details_;
  std::vector<Level> levels_;
  Buffer even_{};
  Buffer odd_{};
  Buffer low_;
  Buffer high_;
};

// Transpose of Analysis, from the end to the beginning, so that every coefficient is read before it
// is overwritten. A level of odd length keeps its length.
class Synthesis {
 public:
  Synthesis(double* work, std::size_t length, const FilterPair& filters,
            const std::vector<fog::Span<double>>& details)
      : work_(work), filters_(filters), details_(details) {
    for (const fog::Span<double> detail : details) {
      levels_.push_back({length, (length + 1) / 2});
      length = detail.size;
    }
  }

  // Makes the values of a level from number `first` on.
  void run(std::size_t number = 0, std::size_t first = 0) {
    if (number == levels_.size()) return;
    Level& level = levels_[number];
    while (2 * level.begin > first) {
      const std::size_t begin = (level.begin - 1) / kChunk * kChunk;
      run(number + 1, begin);
      synthesise_chunk(details_[number].data, begin, level);
      level.begin = begin;
    }
  }

 private:
  struct Level {
    std::size_t size;
    std::size_t begin;  // the pairs from here on are made
  };

  void synthesise_chunk(const double* high, std::size_t first, const Level& level) {
    const std::size_t count = level.begin - first;
    if (count == padded(count)) {
      filter(filters_.synthesis, false, work_ + first, high + first, count, even_.data(),
             odd_.data());
    } else {
      const std::size_t inputs = count + filters_.phases() - 1;
      std::copy_n(work_ + first, inputs, low_.data());
      std::copy_n(high + first, inputs, high_.data());
      filter(filters_.synthesis, false, low_.data(), high_.data(), padded(count), even_.data(),
             odd_.data());
    }
    const std::size_t whole = std::min(count, level.size / 2 - first);
    double* to = work_ + 2 * first;
    for (std::size_t i = 0; i < whole; ++i) {
      to[2 * i] = even_[i];
      to[2 * i + 1] = odd_[i];
    }
    if (whole < count) to[2 * whole] = even_[whole];
  }

  double* work_;
  const FilterPair& filters_;
  const std::vector<fog::Span<double>>& details_;
  std::vector<Level> levels_;
  Buffer low_{};
  Buffer high_{};
  Buffer even_;
  Buffer odd_;
};

// Work space of a transform in place. Levels of a signal shorter than the filter are longer than
// it.
class WorkSpace {
 public:
  WorkSpace(fog::Span<double> values, std::size_t longest)
      : longer_(longest > values.size ? longest : 0),
        data_(longer_.empty() ? values.data : longer_.data()) {}
  double* data() const { return data_; }

 private:
  std::vector<double> longer_;
  double* data_;
};

}  // namespace

int max_levels(std::size_t length, std::size_t taps) {
  int levels = 0;
  for (std::size_t length_needed = 2 * (taps - 1); length_needed <= length; length_needed *= 2)
    ++levels;
  return levels;
}

Decomposition decompose(fog::Span<double> values, const std::vector<double>& lowpass, int levels,
                        Extension extension) {
  const FilterPair filters(lowpass);
  std::vector<std::size_t> sizes;
  for (std::size_t size = values.size; levels > 0; --levels) {
    sizes.push_back(size = coefficients_of(size, filters));
  }
  const std::size_t coarsest = sizes.empty() ? values.size : sizes.back();
  Decomposition result;
  result.coefficients.reset(new double[std::accumulate(sizes.begin(), sizes.end(), coarsest)]);
  result.approximation = {result.coefficients.get(), coarsest};
  double* free = result.approximation.end();
  for (const std::size_t size : sizes) {
    result.details.push_back({free, size});
    free += size;
  }
  const WorkSpace work(values, filters.length());
  if (work.data() != values.data) std::copy(values.begin(), values.end(), work.data());
  Analysis(work.data(), values.size, filters, extension, result.details).run();
  std::copy_n(work.data(), coarsest, result.approximation.data);
  return result;
}

void reconstruct(const Decomposition& decomposition, const std::vector<double>& lowpass,
                 fog::Span<double> values) {
  const FilterPair filters(lowpass);
  const fog::Span<double> coarsest = decomposition.approximation;
  const WorkSpace work(values, coarsest.size);
  std::copy(coarsest.begin(), coarsest.end(), work.data());
  Synthesis(work.data(), values.size, filters, decomposition.details).run();
  if (work.data() != values.data) std::copy_n(work.data(), values.size, values.data);
}

}  // namespace fogcomp::denoise
