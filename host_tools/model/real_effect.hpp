#pragma once

#include <cstddef>

#include "core/thermal/signals.hpp"
#include "model/real_numbers.hpp"

namespace fogcomp::model {

/// A term of the drift in double, for identification: an effect of the firmware's registry or an
/// expression.
class RealEffect {
 public:
  virtual ~RealEffect() = default;
  virtual std::size_t regressor_count() const = 0;
  virtual void reset(const fog::Signals<RealNumbers>& signals) = 0;
  /// Advances by `count` blocks; writes regressor_count() values of each, block after block.
  virtual void run(const fog::Signals<RealNumbers>* signals, std::size_t count,
                   double* regressors) = 0;
  void step(const fog::Signals<RealNumbers>& signals, double* regressors) {
    run(&signals, 1, regressors);
  }
};

}  // namespace fogcomp::model
