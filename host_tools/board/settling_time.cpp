#include "board/settling_time.hpp"

#include <algorithm>

#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

// Lags of lags settle one after the other: the largest sum of time constants that are nested.
double slowest_chain_s(const model::Expression& expression, const std::vector<double>& constants) {
  std::vector<double> sums(expression.nodes.size());
  for (std::size_t i = 0; i < expression.nodes.size(); ++i) {
    const model::ExpressionNode& node = expression.nodes[i];  // without operands: left, right 0
    sums[i] = node.kind == model::NodeKind::lag ? sums[node.left] + constants[node.right]
                                                : std::max(sums[node.left], sums[node.right]);
  }
  return sums.empty() ? 0 : sums.back();
}

double slowest_lag_s(const model::EffectTerm& term) {
  double slowest = 0;
  if (term.expression) {
    const model::Expression& expression = term.expression->expression;
    return slowest_chain_s(expression, expression.constants(term.shape()));
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

std::string settling_words(const model::Model& model) {
  std::vector<std::string> lags;
  for (const model::EffectTerm& term : model.terms) {
    if (slowest_lag_s(term) > 0) lags.push_back(term.name);
  }
  if (lags.empty()) return "";
  return format("no rate is valid for the first %.0f s after power-on, until the lags of ",
                settling_time_s(model)) +
         join(lags, ", ") + " have settled (export --invalid chooses what makes a rate invalid)";
}

}  // namespace fogcomp::board
