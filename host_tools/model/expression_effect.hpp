#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/signals.hpp"
#include "model/expression.hpp"
#include "model/real_effect.hpp"

namespace fogcomp::model {

struct SignalRange {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};
using SignalRanges = std::array<SignalRange, fog::kInputs>;

/// Additional data of a term that is an expression: its regressor is expression / 2^scale_log2.
/// Signals are clamped to `ranges`, their ranges in the fit plus a margin, on host and board alike:
/// there the formula is known to be finite and of limited size.
struct ExpressionTerm {
  Expression expression;
  int scale_log2 = 0;
  SignalRanges ranges{};
};

/// The regressor of an expression, in double.
class ExpressionEffect final : public RealEffect {
 public:
  /// `parameters` in the order of Expression::parameters.
  ExpressionEffect(ExpressionTerm term, const std::vector<double>& parameters, double block_s);

  std::size_t regressor_count() const override { return 1; }
  void reset(const fog::Signals<RealNumbers>& signals) override { evaluate(signals, true); }
  void run(const fog::Signals<RealNumbers>* signals, std::size_t count,
           double* regressors) override {
    for (std::size_t i = 0; i < count; ++i) regressors[i] = evaluate(signals[i], false);
  }

 private:
  // A node that is no constant.
  struct Varying {
    std::size_t node = 0;
    double decay = 0;  // of a lag, per block
    double state = 0;  // of lags, plays and highest values
  };

  double evaluate(const fog::Signals<RealNumbers>& signals, bool restart);

  ExpressionTerm term_;
  double block_s_;
  double unit_;                 // of the regressor: expression / 2^scale_log2
  std::vector<double> values_;  // of all nodes; constants never change
  std::vector<Varying> varying_;
  bool started_ = false;
};

}  // namespace fogcomp::model
