#include "model/expression_effect.hpp"

#include <algorithm>
#include <cmath>

#include "model/input_value.hpp"

namespace fogcomp::model {

ExpressionEffect::ExpressionEffect(ExpressionTerm term, const std::vector<double>& parameters,
                                   double block_s)
    : term_(std::move(term)),
      block_s_(block_s),
      unit_(std::ldexp(1, -term_.scale_log2)),
      values_(term_.expression.constants(parameters)) {
  const std::vector<ExpressionNode>& nodes = term_.expression.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].constant) continue;
    // Time constants do not vary.
    const double decay =
        nodes[i].kind == NodeKind::lag ? RealNumbers::decay(block_s / values_[nodes[i].right]) : 0;
    varying_.push_back({i, decay, 0});
  }
}

double ExpressionEffect::evaluate(const fog::Signals<RealNumbers>& signals, bool restart) {
  for (Varying& one : varying_) {
    const ExpressionNode& node = term_.expression.nodes[one.node];
    const double left = values_[node.left];
    const double right = values_[node.right];
    double& value = values_[one.node];
    if (node.kind == NodeKind::signal) {
      const SignalRange& range = term_.ranges[static_cast<std::size_t>(node.signal)];
      value = std::clamp(value_of(node.signal, signals, block_s_), range.min, range.max);
    } else if (node.kind == NodeKind::lag) {
      one.state = restart ? left : one.state + (left - one.state) * one.decay;
      value = one.state;
    } else if (node.kind == NodeKind::play) {
      const bool is_new = restart && !started_;
      one.state = is_new ? left : std::clamp(one.state, left - right, left + right);
      value = one.state;
    } else if (node.kind == NodeKind::highest) {
      one.state = started_ ? std::max(one.state, left) : left;
      value = one.state;
    } else {
      value = apply(node.kind, left, right);
    }
  }
  started_ = true;
  return values_.back() * unit_;
}

}  // namespace fogcomp::model
