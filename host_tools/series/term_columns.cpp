#include "series/term_columns.hpp"

#include "model/catalogue.hpp"

namespace fogcomp {

std::vector<ColumnRange> columns_of(const std::vector<EffectTerm>& terms, double block_s) {
  std::vector<ColumnRange> columns;
  Eigen::Index first = 0;
  for (const EffectTerm& term : terms) {
    const auto count = static_cast<Eigen::Index>(make_effect(term, block_s)->regressor_count());
    columns.push_back({first, count});
    first += count;
  }
  return columns;
}

}  // namespace fogcomp
