#pragma once

#include <cstddef>
#include <vector>

#include "fit/perceptron.hpp"

namespace fogcomp {

/// Rows come in multiples of this.
constexpr std::size_t kBatchStep = 8;

/// Where the rows of a batch lie, a column per quantity.
struct BatchColumns {
  std::vector<const double*> inputs;
  const double* target = nullptr;
  const double* weights = nullptr;
  std::size_t rows = 0;  ///< multiple of kBatchStep
};

/// The inner loops of training. Logistic and hyperbolic tangent within 4e-16 and 8e-16 absolute
/// (test: a sweep). Sums run in eight interleaved parts whatever the registers' width, and nothing
/// is fused, so results are the same to the bit on every processor of the architecture.
struct BatchKernels {
  /// Sum of weight * (target - output)^2.
  double (*cost)(const Perceptron& shape, const double* weights, const BatchColumns& batch);
  /// The same, and its derivative by every weight (shape.size() values).
  double (*cost_and_gradient)(const Perceptron& shape, const double* weights,
                              const BatchColumns& batch, double* gradient);
  /// Values of the hidden neurons (rows x hidden, a column per neuron) and of the output.
  void (*outputs)(const Perceptron& shape, const double* weights, const BatchColumns& batch,
                  double* hidden, double* output);
};

/// For any processor of the architecture.
extern const BatchKernels kPortableBatchKernels;

/// The fastest for the processor that this runs on (AVX2 where there is one).
const BatchKernels& best_batch_kernels();

}  // namespace fogcomp
