#include "model/expression_effect.hpp"

#include <algorithm>
#include <cmath>

#include "model/input_value.hpp"

namespace fogcomp::model {

ExpressionEffect::ExpressionEffect(ExpressionTerm term, const std::vector<double>& parameters,
                                   double block_s)
    : term_(std::move(term)),
      block_s_(block_s),
      values_(term_.expression.constants(parameters)),
      states_(values_.size()) {}

double ExpressionEffect::evaluate(const fog::Signals<RealNumbers>& signals, bool restart) {
  const std::vector<ExpressionNode>& nodes = term_.expression.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ExpressionNode& node = nodes[i];
    if (node.constant) continue;
    const double left = values_[node.left];
    const double right = values_[node.right];
    double& state = states_[i];
    if (node.kind == NodeKind::signal) {
      const SignalRange& range = term_.ranges[static_cast<std::size_t>(node.signal)];
      values_[i] = std::clamp(value_of(node.signal, signals, block_s_), range.min, range.max);
    } else if (node.kind == NodeKind::lag) {
      state = restart ? left : state + (left - state) * RealNumbers::decay(block_s_ / right);
      values_[i] = state;
    } else if (node.kind == NodeKind::play) {
      const bool is_new = restart && !started_;
      state = is_new ? left : std::clamp(state, left - right, left + right);
      values_[i] = state;
    } else if (node.kind == NodeKind::highest) {
      state = started_ ? std::max(state, left) : left;
      values_[i] = state;
    } else {
      values_[i] = apply(node.kind, left, right);
    }
  }
  started_ = true;
  return std::ldexp(values_.back(), -term_.scale_log2);
}

}  // namespace fogcomp::model
