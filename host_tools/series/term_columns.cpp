#include "series/term_columns.hpp"

#include "model/catalogue.hpp"

namespace fogcomp::series {

std::vector<ColumnRange> columns_of(const std::vector<model::EffectTerm>& terms, double block_s) {
  std::vector<ColumnRange> columns;
  Eigen::Index first = 0;
  for (const model::EffectTerm& term : terms) {
    const auto count =
        static_cast<Eigen::Index>(model::make_effect(term, block_s)->regressor_count());
    columns.push_back({first, count});
    first += count;
  }
  return columns;
}

}  // namespace fogcomp::series
