#include "diagnosis/explanation.hpp"

#include <algorithm>
#include <array>

#include "diagnosis/decision_rules.hpp"
#include "support/chi_square.hpp"

namespace fogcomp::diagnosis {
namespace {

double max_unexplained(const Hypothesis& hypothesis) {
  const std::size_t size = hypothesis.parts.size();
  double max = rules::kMaxUnexplained[size - 1];
  if (hypothesis.led_by_event) max = std::min(max, rules::kMaxUnexplainedByEvent);
  if (size == 3 && hypothesis.free_shape)
    max = std::min(max, rules::kMaxUnexplainedByThreeFreeShape);
  return max;
}

}  // namespace

Explanation explain(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                    const series::ColumnRange& structure,
                    const std::vector<Hypothesis>& hypotheses) {
  Explanation result;
  std::array<const Hypothesis*, rules::kMaxUnexplained.size()> best{};
  for (const Hypothesis& hypothesis : hypotheses) {
    const Hypothesis*& place = best[hypothesis.parts.size() - 1];
    if (place == nullptr || hypothesis.chi2_drop > place->chi2_drop) place = &hypothesis;
  }
  const auto left_width = static_cast<double>(structure.count);
  for (std::size_t size = 0; size < best.size() && !result.enough; ++size) {
    if (best[size] == nullptr) continue;
    std::vector<series::ColumnRange> ranges = ranges_of(regressors, *best[size]);
    const double own_width = fit::column_count(ranges);
    ranges.push_back(structure);
    const double all = space.chi2_drop(ranges);
    const double left = all - best[size]->chi2_drop;
    result.best = best[size];
    result.excess = std::max(all - left_width, best[size]->chi2_drop) - own_width;
    result.unexplained =
        result.excess > 0 ? std::clamp((left - left_width) / result.excess, 0.0, 1.0) : 0;
    result.enough =
        result.unexplained < max_unexplained(*best[size]) ||
        tail_log_p(standard_score(std::max(left, 0.0), left_width)) > rules::kLeftoverLogP;
  }
  return result;
}

}  // namespace fogcomp::diagnosis
