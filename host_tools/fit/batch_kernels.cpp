#include "fit/batch_kernels.hpp"

#include <algorithm>
#include <array>

#include "support/packs.hpp"

namespace fogcomp {
namespace {

template <class R>
constexpr std::size_t kBatchPacks = kBatchStep / kLanes<R>;

// 1 / (1 + exp(-x)). With -x = n ln 2 + r and Cody and Waite's rational form
// exp(r) = (q + p) / (q - p) (coefficients: Cephes, exp.c), one division makes it:
// (q - p) / ((q - p) + 2^n (q + p)).
template <class R>
FOGCOMP_INLINE typename R::Pack logistic(typename R::Pack x) {
  using Pack = typename R::Pack;
  using Bits = typename R::Bits;
  constexpr double kMost = 700;  // beyond, the result is 0 or 1 to the last bit anyway
  // Adding this leaves round(v) + 1023 in the lowest 12 bits: the exponent of 2^round(v).
  constexpr double kRound = 6755399441055744.0 + 1023;
  constexpr double kLog2E = 1.4426950408889634;
  constexpr double kLn2High = 6.93145751953125e-1;
  constexpr double kLn2Low = 1.42860682030941723212e-6;
  Pack v = -x;
  v = v > kMost ? Pack{} + kMost : v;
  v = v < -kMost ? Pack{} - kMost : v;
  const Pack shifted = v * kLog2E + kRound;
  const Pack n = shifted - kRound;
  const Pack power = reinterpret_cast<Pack>(reinterpret_cast<Bits>(shifted) << 52);
  const Pack r = v - n * kLn2High - n * kLn2Low;
  const Pack square = r * r;
  const Pack p = r * ((1.26177193074810590878e-4 * square + 3.02994407707441961300e-2) * square +
                      9.99999999999999999910e-1);
  const Pack q = ((3.00198505138664455042e-6 * square + 2.52448340349684104192e-3) * square +
                  2.27265548208155028766e-1) *
                     square +
                 2.0;
  const Pack below = q - p;
  return below / (below + power * (q + p));
}

template <class R>
FOGCOMP_INLINE typename R::Pack activated(fog::Activation activation, typename R::Pack x) {
  switch (activation) {
    case fog::Activation::logsig:
      return logistic<R>(x);
    case fog::Activation::tansig:
      return 2.0 * logistic<R>(2.0 * x) - 1.0;
    case fog::Activation::linear:
      break;
  }
  return x;
}

template <class R>
FOGCOMP_INLINE typename R::Pack slope(fog::Activation activation, typename R::Pack y) {
  switch (activation) {
    case fog::Activation::logsig:
      return y * (1.0 - y);
    case fog::Activation::tansig:
      return 1.0 - y * y;
    case fog::Activation::linear:
      break;
  }
  return typename R::Pack{} + 1.0;
}

// Rows per round: with all neurons' values this stays in the first-level cache.
constexpr std::size_t kChunk = 64;
using Values = std::array<double, kChunk>;

// kBatchStep interleaved sums.
using Lanes = std::array<double, kBatchStep>;

double total(const Lanes& lanes) {
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

template <class R>
struct Sum {
  typename R::Pack packs[kBatchPacks<R>] = {};

  FOGCOMP_INLINE void add_to(Lanes& lanes) const {
    for (std::size_t p = 0; p < kBatchPacks<R>; ++p) {
      double* at = lanes.data() + p * kLanes<R>;
      store<R>(at, load<R>(at) + packs[p]);
    }
  }
};

// Values of a hidden neuron and what it adds to the sum before the output.
template <class R>
FOGCOMP_INLINE void neuron(const Perceptron& shape, const double* w, std::size_t j,
                           const BatchColumns& batch, std::size_t first, std::size_t count,
                           double* values, double* before_output) {
  const auto inputs = static_cast<std::size_t>(shape.inputs);
  const double bias = w[static_cast<std::size_t>(shape.hidden_bias()) + j];
  const double output_weight = w[static_cast<std::size_t>(shape.output_weight()) + j];
  for (std::size_t i = 0; i < count; i += kLanes<R>) {
    typename R::Pack sum = typename R::Pack{} + bias;
    for (std::size_t k = 0; k < inputs; ++k) {
      sum += w[j * inputs + k] * load<R>(batch.inputs[k] + first + i);
    }
    const typename R::Pack value = activated<R>(shape.hidden_activation, sum);
    store<R>(values + i, value);
    store<R>(before_output + i, load<R>(before_output + i) + output_weight * value);
  }
}

// Values of all neurons for a chunk; of the output in `output`.
template <class R>
FOGCOMP_INLINE void forward(const Perceptron& shape, const double* w, const BatchColumns& batch,
                            std::size_t first, std::size_t count, Values* hidden, double* output) {
  const double bias = w[shape.output_bias()];
  std::fill_n(output, count, bias);
  const auto neurons = static_cast<std::size_t>(shape.hidden);
  for (std::size_t j = 0; j < neurons; ++j) {
    neuron<R>(shape, w, j, batch, first, count, hidden[j].data(), output);
  }
  for (std::size_t i = 0; i < count; i += kLanes<R>) {
    store<R>(output + i, activated<R>(shape.output_activation, load<R>(output + i)));
  }
}

// Adds weight * error^2 to `cost`; leaves d cost / d (sum before the output) in `output`.
template <class R>
FOGCOMP_INLINE void judge(const Perceptron& shape, const BatchColumns& batch, std::size_t first,
                          std::size_t count, double* output, Lanes& cost) {
  for (std::size_t i = 0; i < count; i += kBatchStep) {
    Sum<R> square;
    for (std::size_t p = 0; p < kBatchPacks<R>; ++p) {
      const std::size_t at = i + p * kLanes<R>;
      const typename R::Pack y = load<R>(output + at);
      const typename R::Pack error = load<R>(batch.target + first + at) - y;
      const typename R::Pack weighted = load<R>(batch.weights + first + at) * error;
      square.packs[p] = weighted * error;
      store<R>(output + at, -2.0 * weighted * slope<R>(shape.output_activation, y));
    }
    square.add_to(cost);
  }
}

// Sum over the chunk of a * b.
template <class R>
FOGCOMP_INLINE void add_products(const double* a, const double* b, std::size_t count,
                                 Lanes& lanes) {
  Sum<R> sum;
  for (std::size_t i = 0; i < count; i += kBatchStep) {
    for (std::size_t p = 0; p < kBatchPacks<R>; ++p) {
      const std::size_t at = i + p * kLanes<R>;
      sum.packs[p] += load<R>(a + at) * load<R>(b + at);
    }
  }
  sum.add_to(lanes);
}

template <class R>
FOGCOMP_INLINE void add_values(const double* a, std::size_t count, Lanes& lanes) {
  Sum<R> sum;
  for (std::size_t i = 0; i < count; i += kBatchStep) {
    for (std::size_t p = 0; p < kBatchPacks<R>; ++p) sum.packs[p] += load<R>(a + i + p * kLanes<R>);
  }
  sum.add_to(lanes);
}

constexpr std::size_t kMostWeights = kMostTrainedHidden * (kMostTrainedInputs + 2) + 1;

template <class R>
FOGCOMP_INLINE double cost_and_gradient(const Perceptron& shape, const double* w,
                                        const BatchColumns& batch, double* gradient) {
  std::array<Values, kMostTrainedHidden> hidden;
  std::array<Lanes, kMostWeights> sums{};
  Values delta;
  Values through;
  Lanes cost{};
  const auto inputs = static_cast<std::size_t>(shape.inputs);
  const auto neurons = static_cast<std::size_t>(shape.hidden);
  const auto hidden_bias = static_cast<std::size_t>(shape.hidden_bias());
  const auto output_weight = static_cast<std::size_t>(shape.output_weight());
  for (std::size_t first = 0; first < batch.rows; first += kChunk) {
    const std::size_t count = std::min(kChunk, batch.rows - first);
    forward<R>(shape, w, batch, first, count, hidden.data(), delta.data());
    judge<R>(shape, batch, first, count, delta.data(), cost);
    add_values<R>(delta.data(), count, sums[output_weight + neurons]);
    for (std::size_t j = 0; j < neurons; ++j) {
      const double* values = hidden[j].data();
      add_products<R>(delta.data(), values, count, sums[output_weight + j]);
      const double weight = w[output_weight + j];
      for (std::size_t i = 0; i < count; i += kLanes<R>) {
        const typename R::Pack value = load<R>(values + i);
        store<R>(&through[i],
                 weight * load<R>(&delta[i]) * slope<R>(shape.hidden_activation, value));
      }
      add_values<R>(through.data(), count, sums[hidden_bias + j]);
      for (std::size_t k = 0; k < inputs; ++k) {
        add_products<R>(through.data(), batch.inputs[k] + first, count, sums[j * inputs + k]);
      }
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(shape.size()); ++i) {
    gradient[i] = total(sums[i]);
  }
  return total(cost);
}

template <class R>
FOGCOMP_INLINE double cost_only(const Perceptron& shape, const double* w,
                                const BatchColumns& batch) {
  std::array<Values, kMostTrainedHidden> hidden;
  Values output;
  Lanes cost{};
  for (std::size_t first = 0; first < batch.rows; first += kChunk) {
    const std::size_t count = std::min(kChunk, batch.rows - first);
    forward<R>(shape, w, batch, first, count, hidden.data(), output.data());
    judge<R>(shape, batch, first, count, output.data(), cost);
  }
  return total(cost);
}

template <class R>
FOGCOMP_INLINE void all_outputs(const Perceptron& shape, const double* w, const BatchColumns& batch,
                                double* hidden_values, double* output) {
  std::array<Values, kMostTrainedHidden> hidden;
  const auto neurons = static_cast<std::size_t>(shape.hidden);
  for (std::size_t first = 0; first < batch.rows; first += kChunk) {
    const std::size_t count = std::min(kChunk, batch.rows - first);
    forward<R>(shape, w, batch, first, count, hidden.data(), output + first);
    for (std::size_t j = 0; j < neurons; ++j) {
      std::copy_n(hidden[j].data(), count, hidden_values + j * batch.rows + first);
    }
  }
}

double cost_portable(const Perceptron& shape, const double* w, const BatchColumns& batch) {
  return cost_only<Sse2>(shape, w, batch);
}
double cost_and_gradient_portable(const Perceptron& shape, const double* w,
                                  const BatchColumns& batch, double* gradient) {
  return cost_and_gradient<Sse2>(shape, w, batch, gradient);
}
void outputs_portable(const Perceptron& shape, const double* w, const BatchColumns& batch,
                      double* hidden, double* output) {
  all_outputs<Sse2>(shape, w, batch, hidden, output);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] double cost_avx2(const Perceptron& shape, const double* w,
                                         const BatchColumns& batch) {
  return cost_only<Avx2>(shape, w, batch);
}
[[gnu::target("avx2")]] double cost_and_gradient_avx2(const Perceptron& shape, const double* w,
                                                      const BatchColumns& batch, double* gradient) {
  return cost_and_gradient<Avx2>(shape, w, batch, gradient);
}
[[gnu::target("avx2")]] void outputs_avx2(const Perceptron& shape, const double* w,
                                          const BatchColumns& batch, double* hidden,
                                          double* output) {
  all_outputs<Avx2>(shape, w, batch, hidden, output);
}
constexpr BatchKernels kAvx2BatchKernels{cost_avx2, cost_and_gradient_avx2, outputs_avx2};
#else
constexpr BatchKernels kAvx2BatchKernels{};
#endif

}  // namespace

const BatchKernels kPortableBatchKernels{cost_portable, cost_and_gradient_portable,
                                         outputs_portable};

const BatchKernels& best_batch_kernels() {
  static const BatchKernels& best = has_avx2() ? kAvx2BatchKernels : kPortableBatchKernels;
  return best;
}

}  // namespace fogcomp
