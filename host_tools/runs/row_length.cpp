#include "runs/row_length.hpp"

#include <algorithm>

#include "runs/decision_rules.hpp"
#include "series/rows.hpp"
#include "support/text.hpp"

namespace fogcomp::runs {
namespace {

bool are_same_rows(const std::vector<Run>& runs, double a_s, double b_s) {
  return std::all_of(runs.begin(), runs.end(), [&](const Run& run) {
    const double block_s = run.blocks.block_s;
    return series::row_length_s(a_s, block_s) == series::row_length_s(b_s, block_s);
  });
}

}  // namespace

double sufficient_row_s(double all_s) {
  const auto last = rules::kRowLengths_s.end() - 1;
  return *std::find_if(rules::kRowLengths_s.begin(), last,
                       [&](double row_s) { return all_s <= rules::kMaxRowsToJudge * row_s; });
}

RowLength row_length(const std::vector<Run>& runs, double model_row_s) {
  double all_s = 0;
  for (const Run& run : runs) all_s += run.length_s();
  const double row_s = sufficient_row_s(all_s);
  const bool are_few = model_row_s < row_s && all_s < rules::kMinRowsToJudge * row_s;
  if (are_few || are_same_rows(runs, row_s, model_row_s)) return {model_row_s, ""};
  const double usual_s = rules::kRowLengths_s.front();
  if (row_s == usual_s) return {row_s, ""};
  return {row_s, format("looked at in rows of %g s: of %g s there would be %.0f, more than a "
                        "diagnosis needs",
                        row_s, usual_s, all_s / usual_s)};
}

}  // namespace fogcomp::runs
