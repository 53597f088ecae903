#include "board/settling_time.hpp"

#include <algorithm>

#include "model/catalogue.hpp"

namespace fogcomp::board {
namespace {

double slowest_lag_s(const model::EffectTerm& term) {
  double slowest = 0;
  if (term.expression) {
    const model::Expression& expression = term.expression->expression;
    const std::vector<double> constants = expression.constants(term.shape());
    for (const model::ExpressionNode& node : expression.nodes) {
      if (node.kind == model::NodeKind::lag) slowest = std::max(slowest, constants[node.right]);
    }
    return slowest;
  }
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const fog::Time time = info.parameters[i].time;
    const bool settles = time == fog::Time::constant || time == fog::Time::constant_of_rate;
    if (settles) slowest = std::max(slowest, term.parameters[i].value);
  }
  return slowest;
}

}  // namespace

double settling_time_s(const model::Model& model) {
  double slowest = 0;
  for (const model::EffectTerm& term : model.terms)
    slowest = std::max(slowest, slowest_lag_s(term));
  for (const model::RealInput& input : model.network.inputs)
    slowest = std::max(slowest, input.tau_s);
  return 7 * model.derivative_tau_s + 5 * slowest;
}

}  // namespace fogcomp::board
