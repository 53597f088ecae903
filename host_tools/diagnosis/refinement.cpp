#include "diagnosis/refinement.hpp"

#include <string>
#include <utility>
#include <vector>

#include "model/effect_list.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

AdditionRequest refinement(const model::EffectTerm& term, const std::string& settings) {
  AdditionRequest request{{term.name + ":" + settings}, ""};
  request.refines = true;
  return request;
}

// Frees what the formula of a term leaves out or keeps: all together or, if that is refused, the
// one that leaves least out of sample.
std::optional<TriedAddition> refined(const model::EffectTerm& term, AdditionJudge& judge) {
  std::optional<TriedAddition> best;
  const auto try_one = [&](const std::string& settings) {
    AdditionRequest request = refinement(term, settings);
    if (!judge.may_help(request)) return false;
    TriedAddition tried = judge(std::move(request));
    if (tried.accepted && (!best || tried.score.gain > best->score.gain)) best = std::move(tried);
    return true;
  };
  const std::vector<std::string> settings = model::possible_refinements(term);
  if (settings.empty() || !try_one(join(settings, ",")) || best || settings.size() == 1) {
    return best;
  }
  for (const std::string& one : settings) try_one(one);
  return best;
}

}  // namespace

std::optional<TriedAddition> best_refinement(const model::Model& model, AdditionJudge& judge) {
  std::optional<TriedAddition> best;
  for (const model::EffectTerm& term : model.terms) {
    std::optional<TriedAddition> tried = refined(term, judge);
    if (tried && (!best || tried->score.gain > best->score.gain)) best = std::move(tried);
  }
  return best;
}

}  // namespace fogcomp::diagnosis
